#include "core/settings.h"

namespace wuerfel {

std::string_view to_string(Integrator integrator) {
  switch (integrator) {
    case Integrator::automatic:
      return "auto";
    case Integrator::event:
      return "event";
    case Integrator::rattle:
      return "rattle";
    case Integrator::moreau:
      return "moreau";
    case Integrator::euler:
      return "euler";
    case Integrator::symplectic:
      return "symplectic";
  }
  return "?";
}

std::string_view to_string(Formulation formulation) {
  switch (formulation) {
    case Formulation::points:
      return "points";
    case Formulation::rigid:
      return "rigid";
  }
  return "?";
}

}  // namespace wuerfel
