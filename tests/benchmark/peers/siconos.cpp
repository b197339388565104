/// Single contact problems: our solver beside those of Siconos, in one process.
///
///     OPENBLAS_NUM_THREADS=1 build/peers/tests/benchmark/peers/siconos
///
/// The same frictionless programs three times: as they are, to our solver; as linear
/// complementarity problems z >= 0, w = W z + q >= 0, z w = 0 with W = J M^-1 J', q = J f - b; and
/// as planar friction problems with friction 0. Siconos gets W and q ready made. Every answer is
/// judged by our meter. Prints Markdown.
#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <lcp_cst.h>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

#include "core/qp/qp_solver.h"
#include "tests/benchmark/bench/clock.h"
#include "tests/support/qp_zoo.h"

namespace {

using namespace wuerfel;

constexpr double budget = 0.3;       // s for each figure
constexpr double tolerance = 1e-10;  // ours on its residual, Siconos' on its own relative error
constexpr int most_sweeps = 20'000;  // of iterative methods
constexpr int most_pivots = 10'000;

using Matrix = std::vector<double>;  // by columns

/// Rows of J, dense: `per_contact` 1 has the program's own; 2 adds a tangent to each, without
/// moment: where friction is 0 its force is 0, whatever the row.
Matrix dense_rows(const QuadraticProgram& program, std::size_t per_contact) {
  const std::size_t contacts = program.bound.size();
  const std::size_t rows = per_contact * contacts;
  const auto block_size = static_cast<std::size_t>(program.block_size);
  Matrix J(rows * program.mass.size());
  for (std::size_t i = 0; i < contacts; ++i) {
    const std::size_t row = per_contact * i;
    for (int e = program.row_start[i]; e < program.row_start[i + 1]; ++e) {
      const auto g = program.entry(e);
      const std::size_t column =
          block_size * static_cast<std::size_t>(program.entry_block[static_cast<std::size_t>(e)]);
      for (std::size_t k = 0; k < g.size(); ++k)
        J[row + rows * (column + k)] = g[k];
      if (per_contact == 1) continue;
      J[row + 1 + rows * column] = -g[1];
      J[row + 1 + rows * (column + 1)] = g[0];
    }
  }
  return J;
}

/// W = J M^-1 J' and q = J f - b.
struct Delassus {
  int size = 0;
  Matrix W;
  std::vector<double> q;
};

Delassus delassus(const QuadraticProgram& program, std::size_t per_contact) {
  const Matrix J = dense_rows(program, per_contact);
  const std::size_t n = per_contact * program.bound.size();
  Delassus result{static_cast<int>(n), Matrix(n * n), std::vector<double>(n)};
  for (std::size_t i = 0; i < program.bound.size(); ++i)
    result.q[i * per_contact] = -program.bound[i];
  for (std::size_t k = 0; k < program.mass.size(); ++k) {
    for (std::size_t j = 0; j < n; ++j) {
      const double g = J[j + n * k];
      if (g == 0.0) continue;
      result.q[j] += g * program.target[k];
      for (std::size_t i = 0; i < n; ++i)
        result.W[i + n * j] += J[i + n * k] * g / program.mass[k];
    }
  }
  return result;
}

/// x = f + M^-1 J' lambda, and what the meter says of it.
double residual(const QuadraticProgram& program, const std::vector<double>& multiplier) {
  std::vector<double> x = program.target;
  for (std::size_t i = 0; i < multiplier.size(); ++i) {
    for (int e = program.row_start[i]; e < program.row_start[i + 1]; ++e) {
      const auto g = program.entry(e);
      const auto first =
          static_cast<std::size_t>(program.block_size)
          * static_cast<std::size_t>(program.entry_block[static_cast<std::size_t>(e)]);
      for (std::size_t k = 0; k < g.size(); ++k)
        x[first + k] += g[k] * multiplier[i] / program.mass[first + k];
    }
  }
  return optimality_residual(program, x, multiplier).worst();
}

struct Answer {
  double seconds = 0.0;
  double residual = 0.0;
  bool claimed = false;  ///< the solver says that it has succeeded
};

Answer ours(const QuadraticProgram& program) {
  const std::unique_ptr<QpSolver> solver = make_qp_solver(QpMethod::automatic);
  QpResult result;
  const BestTime time = best_time(budget, [&] {
    solver->forget();
    solver->solve(program, result);
  });
  return {time.seconds, result.residual.worst(), result.status == QpStatus::optimal};
}

/// As what Siconos gets a program.
enum class Form { complementarity, friction, sparse_friction };

struct Method {
  const char* name;
  int id;
  int most_iterations;
  Form form;
};

/// Neither enumeration, which is for a dozen contacts, nor NSQP, which Debian builds without its
/// quadratic programming (it aborts: "ql0001 is not available").
constexpr std::array methods{
    Method{"LCP Lemke", SICONOS_LCP_LEMKE, most_pivots, Form::complementarity},
    Method{"LCP pivot", SICONOS_LCP_PIVOT, most_pivots, Form::complementarity},
    Method{"LCP Newton min", SICONOS_LCP_NEWTON_MIN_FBLSA, 1000, Form::complementarity},
    Method{"LCP Newton FB", SICONOS_LCP_NEWTON_FB_FBLSA, 1000, Form::complementarity},
    Method{"LCP PGS", SICONOS_LCP_PGS, most_sweeps, Form::complementarity},
    Method{"LCP CPG", SICONOS_LCP_CPG, most_sweeps, Form::complementarity},
    Method{"2D friction NSGS", SICONOS_FRICTION_2D_NSGS, most_sweeps, Form::friction},
    Method{"2D friction NSGS, sparse", SICONOS_FRICTION_2D_NSGS, most_sweeps,
           Form::sparse_friction},
    Method{"2D friction CPG", SICONOS_FRICTION_2D_CPG, most_sweeps, Form::friction},
    Method{"2D friction Lemke", SICONOS_FRICTION_2D_LEMKE, most_pivots, Form::friction},
};

using Options = std::unique_ptr<SolverOptions, void (*)(SolverOptions*)>;

Options options_of(const Method& method) {
  Options options(solver_options_create(method.id), solver_options_delete);
  options->iparam[SICONOS_IPARAM_MAX_ITER] = method.most_iterations;
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->filterOn = false;  // no second look at the answer: ours is not counted either
  return options;
}

struct Release {
  void operator()(NumericsMatrix* matrix) const { NM_free(matrix); }
};
using SiconosMatrix = std::unique_ptr<NumericsMatrix, Release>;

SiconosMatrix dense_matrix(const Delassus& given) {
  SiconosMatrix matrix(NM_create(NM_DENSE, given.size, given.size));
  std::copy(given.W.begin(), given.W.end(), matrix->matrix0);
  return matrix;
}

/// Blocks of one contact by one contact, those of zeros left out.
SiconosMatrix block_matrix(const Delassus& given) {
  const SiconosMatrix dense = dense_matrix(given);
  const SiconosMatrix sparse(NM_create(NM_SPARSE, given.size, given.size));
  NM_copy_to_sparse(dense.get(), sparse.get(), 0.0);
  SparseBlockStructuredMatrix* blocks = SBM_new();
  SBM_from_csparse(2, NM_csc(sparse.get()), blocks);
  return SiconosMatrix(NM_create_from_data(NM_SPARSE_BLOCK, given.size, given.size, blocks));
}

Answer theirs(const QuadraticProgram& program, const Method& method) {
  const std::size_t per_contact = method.form == Form::complementarity ? 1 : 2;
  Delassus given = delassus(program, per_contact);
  const SiconosMatrix W =
      method.form == Form::sparse_friction ? block_matrix(given) : dense_matrix(given);
  std::vector<double> friction(static_cast<std::size_t>(program.rows()));
  LinearComplementarityProblem lcp{given.size, W.get(), given.q.data()};
  FrictionContactProblem contacts{2, program.rows(), W.get(), given.q.data(), friction.data()};
  const Options options = options_of(method);
  std::vector<double> z;
  std::vector<double> w;
  int info = 0;
  const BestTime time = best_time(budget, [&] {
    z.assign(given.q.size(), 0.0);
    w.assign(given.q.size(), 0.0);
    info = method.form == Form::complementarity
               ? linearComplementarity_driver(&lcp, z.data(), w.data(), options.get())
               : fc2d_driver(&contacts, z.data(), w.data(), options.get());
  });
  std::vector<double> multiplier;
  for (std::size_t i = 0; i < z.size(); i += per_contact)
    multiplier.push_back(z[i]);
  return {time.seconds, residual(program, multiplier), info == 0};
}

/// What was stdout. Siconos writes warnings there, which go nowhere: its answers are judged.
std::FILE* take_stdout() {
  std::FILE* table = fdopen(dup(STDOUT_FILENO), "w");
  if (table == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr) {
    std::fprintf(stderr, "siconos: cannot redirect stdout\n");
    std::exit(1);
  }
  return table;
}

/// A cell of the table.
void print(std::FILE* table, const Answer& answer) {
  const bool small = answer.seconds < 1e-3;
  std::fprintf(table, " %.3g %s, %.0e%s |", answer.seconds * (small ? 1e6 : 1e3),
               small ? "us" : "ms", answer.residual, answer.claimed ? "" : " (gives up)");
  std::fflush(table);
}

void print_head(std::FILE* table) {
  std::fprintf(table, "| program | bodies, contacts | wuerfel |");
  for (const Method& method : methods)
    std::fprintf(table, " %s |", method.name);
  std::fprintf(table, "\n|---|---|---|");
  for (std::size_t k = 0; k < methods.size(); ++k)
    std::fprintf(table, "---|");
  std::fprintf(table, "\n");
}

std::vector<test::ZooProgram> programs() {
  const test::ZooOptions moved{.shift = 1e-3, .turn = 3e-4};
  const test::ZooOptions masses{
      .shift = 1e-3, .turn = 3e-4, .masses = test::Masses::alternating_1e6};
  const test::ZooOptions velocity{.shift = 1e-3, .turn = 3e-4, .velocity = true};
  return {{"tower 10", test::tower(10, moved)},
          {"tower 30", test::tower(30, moved)},
          {"tower 100", test::tower(100, moved)},
          {"tower 30, masses 1 and 1e6", test::tower(30, masses)},
          {"pile 30", test::pile(30, moved)},
          {"pile 100", test::pile(100, moved)},
          {"pile 100, impact", test::pile(100, velocity)},
          {"pyramid of 10 rows at rest", test::pyramid(10)},
          {"wall 6 x 6 at rest", test::wall(6, 6)},
          {"wall 6 x 6", test::wall(6, 6, moved)}};
}

}  // namespace

int main() {
  std::FILE* table = take_stdout();
  print_head(table);
  for (const auto& [name, program] : programs()) {
    std::fprintf(table, "| %s | %d, %d |", name.c_str(), program.blocks(), program.rows());
    print(table, ours(program));
    for (const Method& method : methods)
      print(table, theirs(program, method));
    std::fprintf(table, "\n");
  }
  std::fclose(table);
  return 0;
}
