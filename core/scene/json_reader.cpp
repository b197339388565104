#include "core/scene/json_reader.h"

#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/scene/scene_text.h"

namespace wuerfel {
namespace {

using nlohmann::json;

/// Receives the events of the parser and builds the tree. `open_` holds the arrays and tables that
/// are not closed yet, the innermost last.
class TreeBuilder : public nlohmann::json_sax<json> {
 public:
  TreeBuilder(std::string_view text, const SceneSource& source) : text_(text), source_(source) {}

  Value take() { return std::move(root_); }

  bool null() override { return add(ForeignValue{"null"}); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(std::int64_t{value}); }
  bool number_unsigned(number_unsigned_t value) override {
    if (value > static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max())) {
      return add(static_cast<double>(value));
    }
    return add(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return add(ForeignValue{"binary data"}); }

  bool start_object(std::size_t /*elements*/) override { return open(Value::Table{}); }
  bool start_array(std::size_t /*elements*/) override { return open(Value::Array{}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    open_.back().key = std::move(value);
    return true;
  }

  bool parse_error(std::size_t position,
                   const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    std::string message = error.what();
    // "[json.exception...] parse error at line 1, column 2: reason": the place is ours to tell.
    const std::size_t tag = message.find("] ");
    if (tag != std::string::npos) message.erase(0, tag + 2);
    if (message.starts_with("parse error")) {
      const std::size_t reason = message.find(": ");
      if (reason != std::string::npos) message.erase(0, reason + 2);
    }
    source_.fail(place_at(text_, position > 0 ? position - 1 : 0), "",
                 "not valid JSON: " + message);
    return false;  // never: fail throws
  }

 private:
  struct Open {
    Value value;
    std::string key;  ///< of the member that comes next, for tables
  };

  template <class T>
  bool add(T&& data) {
    return put({std::forward<T>(data), {}});
  }

  bool put(Value&& value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (auto* items = std::get_if<Value::Array>(&open_.back().value.data)) {
      items->push_back(std::move(value));
    } else {
      std::get<Value::Table>(open_.back().value.data)
          .push_back({std::move(open_.back().key), {}, std::move(value)});
    }
    return true;
  }

  template <class T>
  bool open(T&& data) {
    open_.push_back({{std::forward<T>(data), {}}, {}});
    return true;
  }

  bool close() {
    Value closed = std::move(open_.back().value);
    open_.pop_back();
    return put(std::move(closed));
  }

  std::string_view text_;
  const SceneSource& source_;
  std::vector<Open> open_;
  Value root_;
};

}  // namespace

Value read_json(std::string_view text, const SceneSource& source) {
  TreeBuilder builder(text, source);
  json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace wuerfel
