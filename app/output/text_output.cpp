#include "app/output/text_output.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <system_error>
#include <unistd.h>

#include <fmt/core.h>

#include "app/cli/is_folder.h"
#include "app/cli/stop_signal.h"
#include "render/error.h"

namespace wuerfel {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16U;  // bytes

/// Opens a pipe, a device or a stream for writing. A pipe waits for its reader, but not against a signal; -1: errno says why not.
int open_special(const std::string& path) {
  constexpr int pause = 50;  // ms
  std::error_code ignored;
  const bool is_pipe = std::filesystem::is_fifo(path, ignored);
  int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK);
  while (descriptor < 0 && errno == ENXIO && is_pipe) {
    StopSignal(StopSignal::Ear::deaf).check();
    ::poll(nullptr, 0, pause);
    descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK);
  }
  if (descriptor >= 0)
    ::fcntl(descriptor, F_SETFL, O_WRONLY | O_APPEND);  // what is written may wait again
  return descriptor;
}

bool is_pipe_or_device(const std::string& path) {
  std::error_code ignored;
  using std::filesystem::file_type;
  const file_type type = std::filesystem::status(path, ignored).type();
  return type == file_type::fifo || type == file_type::character || type == file_type::socket;
}

/// /dev/stdout and its like: links of the system to what is open already, files too.
bool is_stream(const std::string& path) {
  std::error_code ignored;
  const std::string whole = std::filesystem::absolute(path, ignored).lexically_normal().string();
  return whole.starts_with("/dev/") || whole.starts_with("/proc/");
}

}  // namespace

TextOutput::TextOutput(const std::string& path) : name_(path) {
  if (path == "-") {
    name_ = "standard output";
    descriptor_ = STDOUT_FILENO;
  } else if (is_pipe_or_device(path) || is_stream(path)) {
    descriptor_ = open_special(path);
    if (descriptor_ < 0) fail();
  } else if (is_folder(path)) {
    throw OutputError(fmt::format("cannot write {}: it is a folder", path));
  } else {
    file_.emplace(path);
  }
}

TextOutput::~TextOutput() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

void TextOutput::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void TextOutput::write(std::span<const std::uint8_t> bytes) {
  write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void TextOutput::finish() {
  flush();
  if (file_) file_->commit();
}

void TextOutput::flush() {
  std::string_view rest = buffer_;
  if (file_) {
    file_->write({reinterpret_cast<const std::uint8_t*>(rest.data()), rest.size()});
    rest = {};
  }
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  buffer_.clear();
}

void TextOutput::fail() const {
  // As `| head` ends other programs: without a word.
  if (errno == EPIPE && descriptor_ == STDOUT_FILENO) throw Interrupted{SIGPIPE};
  throw OutputError(
      fmt::format("cannot write {}: {}", name_, std::generic_category().message(errno)));
}

void write_text(const std::string& path, std::string_view text) {
  TextOutput output(path);
  output.write(text);
  output.finish();
}

}  // namespace wuerfel
