#include "core/qp/methods/few_rows.h"

#include <algorithm>
#include <cmath>

#include "core/qp/refinement.h"

namespace wuerfel {
namespace {

/// J x of a row of cubes.
double value_of(const QuadraticProgram& p, int row, const double* x) {
  const int* start = p.row_start.data() + row;
  const int* block = p.entry_block.data() + start[0];
  const double* J = p.coefficients.data() + start[0] * cube_size;
  double sum = 0.0;
  for (int e = start[0]; e < start[1]; ++e, J += cube_size) {
    const double* at = x + *block++ * cube_size;
    sum += J[0] * at[0];
    sum += J[1] * at[1];
    sum += J[2] * at[2];
  }
  return sum;
}

/// x += M^-1 row' * factor, of a row of cubes.
void push_cubes(const QuadraticProgram& p, int row, double factor, double* x) {
  const int* start = p.row_start.data() + row;
  const int* block = p.entry_block.data() + start[0];
  const double* J = p.coefficients.data() + start[0] * cube_size;
  const double* mass = p.mass.data();
  for (int e = start[0]; e < start[1]; ++e, J += cube_size) {
    const int first = *block++ * cube_size;
    x[first] += J[0] * factor / mass[first];
    x[first + 1] += J[1] * factor / mass[first + 1];
    x[first + 2] += J[2] * factor / mass[first + 2];
  }
}

/// r := S^-1 r with the whole triangle of the factor, row by row, of few rows.
inline void substitute_few(const double* l, const double* inverse, int rows, double* r) {
  for (int i = 0; i < rows; ++i, ++l) {
    for (int j = 0; j < i; ++j)
      r[i] -= *l++ * r[j];
    r[i] *= inverse[i];
  }
  for (int i = rows - 1; i >= 0; --i) {
    r[i] *= inverse[i];
    l -= i + 1;
    for (int j = 0; j < i; ++j)
      r[j] -= l[j] * r[i];
  }
}

/// One row or two, known to the compiler, stay in registers; 0: as many as there are.
template <int known_rows>
[[gnu::noinline]] void move(const QuadraticProgram& p,
                            const std::vector<int>& order,
                            const double* factor,
                            const double* inverse,
                            double* x,
                            double* multiplier) {
  const int rows = known_rows > 0 ? known_rows : static_cast<int>(order.size());
  const int* row = order.data();
  double r[few_rows];
  double scale = 0.0;
  for (int round = 0; round <= most_refinements; ++round) {
    double worst = 0.0;
    for (int i = 0; i < rows; ++i) {
      const double b = p.bound[row[i]];
      const double reached = value_of(p, row[i], x);
      if (round == 0) scale = std::max(scale, std::max(std::abs(b), std::abs(reached)));
      r[i] = b - reached;
      if (inverse[i] != 0.0) worst = std::max(worst, std::abs(r[i]));
    }
    if (worst <= refined_share * scale) return;
    substitute_few(factor, inverse, rows, r);
    for (int i = 0; i < rows; ++i) {
      if (r[i] == 0.0) continue;
      multiplier[row[i]] += r[i];
      push_cubes(p, row[i], r[i], x);
    }
  }
}

}  // namespace

void move_onto_few_rows(const QuadraticProgram& p,
                        const std::vector<int>& order,
                        const double* factor,
                        const double* inverse,
                        double* x,
                        double* multiplier) {
  const auto rows = std::ssize(order);
  const auto move_known = rows == 1 ? move<1> : rows == 2 ? move<2> : move<0>;
  move_known(p, order, factor, inverse, x, multiplier);
}

}  // namespace wuerfel
