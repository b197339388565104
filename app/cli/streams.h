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

/// What was asked for and is not done, and why.
class Notes {
 public:
  /// When notes are said: at once, never, or by somebody else when their turn has come.
  enum class Voice { at_once, quiet, later };

  explicit Notes(Voice voice = Voice::at_once) : voice_(voice) {}
  void add(const std::string& text);
  /// Of what went wrong: said even where it is quiet.
  void warn(const std::string& text);
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }
  /// Lines for standard error that nobody has said yet.
  [[nodiscard]] const std::vector<std::string>& unsaid() const { return unsaid_; }

 private:
  void tell(std::string line);

  Voice voice_;
  std::vector<std::string> texts_;
  std::vector<std::string> unsaid_;
};

}  // namespace wuerfel
