/// The options of one command: declared one by one, read strictly, told with --help.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace wuerfel {

/// An option as it was declared, for whoever tells about it.
struct DeclaredOption {
  std::vector<std::string> names;   ///< "--output", "-o"
  std::string type;                 ///< "FILE"; empty: it takes nothing
  std::string meaning;              ///< in a few words
  std::vector<std::string> values;  ///< all there are, where they can be counted
};

/// A word of a line that Options::parse_line reads, whatever is in it: in "", with \ before " and \.
std::string quoted_word(std::string_view word);

class Options {
 public:
  /// What becomes of the text behind an option. What it does not understand is a UsageError that
  /// names the option.
  using Take = std::function<void(const std::string&)>;

  /// `command` as in "wuerfel check"; `meaning` in a few words.
  Options(const std::string& command, const std::string& meaning);
  ~Options();
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;

  /// Arguments without a dash, in the order of their declaration.
  void argument(const std::string& name, const std::string& meaning, std::string& value);
  void optional_argument(const std::string& name, const std::string& meaning, std::string& value);
  /// One or more of them; the last to be declared.
  void arguments(const std::string& name,
                 const std::string& meaning,
                 std::vector<std::string>& values);

  /// `names` as in "-o,--output", `type` as in "FILE". May be given again and again.
  void value(const std::string& names,
             const std::string& type,
             const std::string& meaning,
             const Take& take);
  /// May be given once.
  void single(const std::string& names,
              const std::string& type,
              const std::string& meaning,
              const Take& take);
  void text(const std::string& names,
            const std::string& type,
            const std::string& meaning,
            std::string& value);
  /// The same, and has to be given.
  void required_text(const std::string& names,
                     const std::string& type,
                     const std::string& meaning,
                     std::string& value);
  /// A flag that may be followed by a text, `--name TEXT` or `--name=TEXT`, where that `fits`; else
  /// `all` is taken, and what follows is an argument. What is behind `=` is always taken.
  void optional_value(const std::string& name,
                      const std::string& type,
                      const std::string& meaning,
                      std::function<bool(const std::string&)> fits,
                      const Take& take);
  void flag(const std::string& names, const std::string& meaning, bool& value);
  /// All values that an option takes, as completions of shells offer them.
  void offer(const std::string& name, std::vector<std::string> values);

  /// False where help was asked for. Throws UsageError, with a suggestion where an option looks
  /// misspelt.
  [[nodiscard]] bool parse(std::vector<std::string> arguments);
  /// Of a line of words between blanks, or quoted_word(). Throws UsageError.
  void parse_line(const std::string& line);
  [[nodiscard]] std::string help() const;
  /// Whether an option was given.
  [[nodiscard]] bool given(const std::string& name) const;
  [[nodiscard]] std::vector<DeclaredOption> declared() const;

 private:
  [[nodiscard]] std::string complaint(const std::string& otherwise) const;

  void join_optional_values(std::vector<std::string>& arguments) const;

  std::unique_ptr<CLI::App> app_;
  std::map<std::string, std::vector<std::string>> values_;
  std::map<std::string, std::function<bool(const std::string&)>> optional_values_;  ///< what fits
};

}  // namespace wuerfel
