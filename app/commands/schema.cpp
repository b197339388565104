#include "app/commands/commands.h"
#include "app/output/text_output.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

Action declare_schema(Options&) {
  return [](const Stopwatch&) {
    write_text("-", scene_schema());
    return ExitCode::fine;
  };
}

}  // namespace wuerfel
