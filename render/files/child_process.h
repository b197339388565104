/// ChildProcess: another program that reads what we send it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace wuerfel {

/// s of processor time of all that the calling thread has waited for.
double cpu_of_children_of_thread();

/// Started with an argument list, never through a shell. Its standard input is ours to write, its
/// standard error is kept for messages, and it is not reached by signals of our terminal.
class ChildProcess {
 public:
  /// `arguments[0]` is looked for on the PATH. `while_waiting` is called ten times a second while
  /// the program keeps us waiting, and may throw to give up. Throws OutputError where it cannot be
  /// started.
  explicit ChildProcess(const std::vector<std::string>& arguments,
                        std::function<void()> while_waiting = {});
  /// Ends the program at once if `wait` was not called.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ChildProcess(ChildProcess&&) = delete;
  ChildProcess& operator=(ChildProcess&&) = delete;

  /// False where the program no longer reads; no signal is raised. Throws what `while_waiting`
  /// throws, as does `wait`.
  [[nodiscard]] bool send(std::span<const std::uint8_t> bytes);
  /// Closes its input, waits for its end and returns its exit status (128 + n after signal n).
  int wait();
  /// What it wrote to its standard error, the last 2000 characters at most.
  std::string error_output() const;

 private:
  void wait_for(int descriptor, short event) const;
  int reap();

  std::function<void()> while_waiting_;
  pid_t pid_ = -1;
  int input_ = -1;
  int error_ = -1;
};

}  // namespace wuerfel
