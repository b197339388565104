#include "core/settings.h"

namespace wuerfel {

std::string_view to_string(Integrator integrator) {
  return integrator == Integrator::euler ? "euler" : "symplectic";
}

std::string_view to_string(Formulation formulation) {
  return formulation == Formulation::points ? "points" : "rigid";
}

std::string_view to_string(QpMethod method) {
  switch (method) {
    case QpMethod::ipopt:
      return "ipopt";
  }
  return "?";
}

}  // namespace wuerfel
