/// The three standard streams: there from the start, and never the end of the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wuerfel {

/// Opens what the caller has closed of standard input, output and error, so that no file of ours
/// gets its number and with it what is meant for people. Reading and writing them fails as before;
/// what goes to standard error is lost.
void hold_standard_streams();

/// Writes to standard error; where that cannot be written nothing happens.
void say(std::string_view text);

/// What was asked for and is not done, and why. Every note is said at once, unless quiet.
class Notes {
 public:
  explicit Notes(bool quiet = false) : quiet_(quiet) {}
  void add(const std::string& text);
  /// Of what went wrong: said even where it is quiet.
  void warn(const std::string& text);
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  bool quiet_;
  std::vector<std::string> texts_;
};

}  // namespace wuerfel
