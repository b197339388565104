#include "app/commands.h"
#include "app/text_output.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

ExitCode schema() {
  write_text("-", scene_schema());
  return ExitCode::fine;
}

}  // namespace wuerfel
