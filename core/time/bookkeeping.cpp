#include "core/time/bookkeeping.h"

namespace wuerfel {

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::touch:
      return "touch";
    case EventKind::release:
      return "release";
    case EventKind::slide_off:
      return "slide_off";
    case EventKind::stick:
      return "stick";
    case EventKind::slip:
      return "slip";
    case EventKind::rest:
      return "rest";
  }
  return "?";
}

}  // namespace wuerfel
