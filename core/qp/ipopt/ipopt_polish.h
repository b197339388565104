/// What an interior point leaves undone: rows that carry no force are met only up to sqrt(mu).
#pragma once

#include "core/qp/ipopt/ipopt_form.h"

namespace wuerfel {

/// Keeps the better of `result` and its projections onto the rows that look tight.
void polish(const QuadraticProgram& program, const ScaledProgram& form, QpResult& result);

}  // namespace wuerfel
