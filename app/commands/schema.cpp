#include "app/commands/commands.h"
#include "app/output/text_output.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

ExitCode schema() {
  write_text("-", scene_schema());
  return ExitCode::fine;
}

}  // namespace wuerfel
