#include "render/files/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "render/error.h"

namespace wuerfel {
namespace {

constexpr off_t kept_error_output = 2000;
constexpr int send_buffer =
    4 << 20;  ///< bytes: more than a frame of 1920x1080 in YUV, so that we seldom wait

// Of each thread, however many it starts one after another. NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
thread_local double cpu_of_children = 0.0;  ///< s

double in_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The file actions and attributes of posix_spawn, released at the end of the scope.
class SpawnSettings {
 public:
  SpawnSettings() {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  SpawnSettings(SpawnSettings&&) = delete;
  SpawnSettings& operator=(SpawnSettings&&) = delete;

  void redirect(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  void discard_output() {
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  }
  /// A process group of its own with default signals: Ctrl-C is ours to handle.
  void shield_from_terminal() {
    sigset_t all;
    sigset_t none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_,
        static_cast<short>(POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP));
  }
  int start(pid_t& pid, const std::vector<std::string>& arguments) {
    std::vector<std::string> copies = arguments;
    std::vector<char*> pointers;
    pointers.reserve(copies.size() + 1);
    for (std::string& argument : copies)
      pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    return posix_spawnp(&pid, pointers[0], &actions_, &attributes_, pointers.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// A descriptor that is closed at the end of the scope.
struct ClosedAtEnd {
  int descriptor;
  explicit ClosedAtEnd(int opened) : descriptor(opened) {}
  ~ClosedAtEnd() { close(descriptor); }
  ClosedAtEnd(const ClosedAtEnd&) = delete;
  ClosedAtEnd& operator=(const ClosedAtEnd&) = delete;
  ClosedAtEnd(ClosedAtEnd&&) = delete;
  ClosedAtEnd& operator=(ClosedAtEnd&&) = delete;
};

}  // namespace

double cpu_of_children_of_thread() { return cpu_of_children; }

ChildProcess::ChildProcess(const std::vector<std::string>& arguments,
                           std::function<void()> while_waiting)
    : while_waiting_(std::move(while_waiting)) {
  // A socket instead of a pipe: writing to it can be told not to raise SIGPIPE.
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw OutputError("cannot make a socket: " + std::generic_category().message(errno));
  }
  input_ = ends[0];
  setsockopt(input_, SOL_SOCKET, SO_SNDBUF, &send_buffer, sizeof send_buffer);
  shutdown(ends[0], SHUT_RD);
  error_ = memfd_create("child-error-output", MFD_CLOEXEC);
  SpawnSettings settings;
  settings.redirect(ends[1], STDIN_FILENO);
  settings.discard_output();
  if (error_ >= 0) settings.redirect(error_, STDERR_FILENO);
  settings.shield_from_terminal();
  const int problem = settings.start(pid_, arguments);
  close(ends[1]);
  if (problem == 0) return;
  close(input_);
  close(error_);
  if (problem == ENOENT) {
    throw OutputError(arguments[0] + " was not found on the PATH; on Debian: apt install "
                      + arguments[0]);
  }
  throw OutputError("cannot start " + arguments[0] + ": "
                    + std::generic_category().message(problem));
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    reap();
  }
  if (error_ >= 0) close(error_);
}

/// Until the descriptor is ready.
void ChildProcess::wait_for(int descriptor, short event) const {
  constexpr int tenth_of_a_second = 100;  // ms
  pollfd watched{descriptor, event, 0};
  while (poll(&watched, 1, while_waiting_ ? tenth_of_a_second : -1) <= 0) {
    if (while_waiting_) while_waiting_();
  }
}

bool ChildProcess::send(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0 && errno == EAGAIN) {
      wait_for(input_, POLLOUT);
      continue;
    }
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

int ChildProcess::wait() {
  close(std::exchange(input_, -1));
  // glibc 2.36 declares pidfd_open for C alone.
  const auto end = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  if (end >= 0) {
    const ClosedAtEnd closed{end};
    wait_for(end, POLLIN);
  }
  return reap();
}

/// The exit status of a program that has ended or is about to.
int ChildProcess::reap() {
  if (input_ >= 0) close(std::exchange(input_, -1));
  int status = 0;
  rusage usage{};
  while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  cpu_of_children += in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

std::string ChildProcess::error_output() const {
  const off_t size = lseek(error_, 0, SEEK_END);
  if (size <= 0) return {};
  std::string text(static_cast<std::size_t>(std::min(size, kept_error_output)), ' ');
  const ssize_t got =
      pread(error_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(std::max<ssize_t>(got, 0));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
    text.pop_back();
  return text;
}

}  // namespace wuerfel
