#include "app/cli/streams.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include <fmt/core.h>

namespace wuerfel {

void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // The lowest number that is free is this one. Opened the wrong way round, data fail as they did.
    ::open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY);
  }
}

void say(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Notes::add(const std::string& text) {
  texts_.push_back(text);
  if (voice_ != Voice::quiet) tell(fmt::format("wuerfel: note: {}\n", text));
}

void Notes::warn(const std::string& text) {
  texts_.push_back(text);
  tell(fmt::format("wuerfel: {}\n", text));
}

void Notes::tell(std::string line) {
  if (voice_ == Voice::later) {
    unsaid_.push_back(std::move(line));
  } else {
    say(line);
  }
}

}  // namespace wuerfel
