// The command line, as a line quoted like those of a shell: understood, or refused. Nothing is run.
#include "app/cli/option_groups.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  PictureOptions picture;
  MotionSettings motion;
  FrameRate rate;
  std::optional<StripGrid> strip;
  try {
    Options options("", "");
    add_picture_options(options, picture);
    add_motion_options(options, motion);
    add_rate_options(options, rate);
    add_strip_option(options, strip);
    options.parse_line(fuzz::text_of(data, size));
  } catch (const UsageError&) {
  }
  return 0;
}
