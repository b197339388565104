#include "app/sweep/columns.h"

namespace wuerfel {

std::string_view to_string(CheckColumn column) {
  switch (column) {
    case CheckColumn::verdict:
      return "verdict";
    case CheckColumn::contacts:
      return "contacts";
    case CheckColumn::margin:
      return "margin";
    case CheckColumn::weakest:
      return "weakest";
    case CheckColumn::causes:
      return "causes";
  }
  return "?";
}

std::string_view to_string(RunColumn column) {
  switch (column) {
    case RunColumn::time_of_fall:
      return "time_of_fall";
    case RunColumn::moved:
      return "moved";
    case RunColumn::at_rest:
      return "at_rest";
    case RunColumn::final_height:
      return "final_height";
    case RunColumn::first_event:
      return "first_event";
    case RunColumn::first_event_time:
      return "first_event_time";
    case RunColumn::events:
      return "events";
  }
  return "?";
}

}  // namespace wuerfel
