// The command line, as a line quoted like those of a shell: understood, or refused. Nothing is run.
#include "app/cli/option_groups.h"
#include "tests/fuzz/target.h"

namespace {

using namespace wuerfel;

/// What the options write into.
struct Values {
  PictureOptions picture;
  MotionSettings motion;
  FrameRate rate;
  std::optional<StripGrid> strip;
};

/// The options are declared once, which takes longer than to read a line; each line finds the values as they were.
class CommandLine {
 public:
  CommandLine() {
    add_picture_options(options_, values_.picture);
    add_motion_options(options_, values_.motion);
    add_rate_options(options_, values_.rate);
    add_strip_option(options_, values_.strip);
  }
  void read(const std::string& line) {
    values_ = {};
    options_.parse_line(line);
  }

 private:
  Options options_{"", ""};
  Values values_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static CommandLine command_line;
  try {
    command_line.read(fuzz::text_of(data, size));
  } catch (const UsageError&) {
  }
  return 0;
}
