// Arbitrary small programs, made of the bytes: no solver hangs or lies. An answer that is called optimal
// is one by the independent residual, and two solvers never say optimal and infeasible.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/qp/qp_solver.h"
#include "tests/fuzz/target.h"

namespace {

using namespace wuerfel;

/// Bytes one after the other, zeros after the last.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  int next() { return at_ < size_ ? data_[at_++] : 0; }
  /// Small integers and quarters mostly, so that rows depend on one another; sometimes any double.
  double number() {
    const int kind = next();
    if (kind < 250) return (next() - 128) / (kind % 4 == 0 ? 4.0 : 1.0);
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
      bits = bits << 8U | static_cast<std::uint64_t>(next());
    return std::bit_cast<double>(bits);
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

QuadraticProgram program_of(Bytes& bytes) {
  QuadraticProgram program;
  program.clear(3);
  const int blocks = 1 + bytes.next() % 4;
  for (int i = 0; i < blocks; ++i) {
    const std::array<double, 3> mass{1.0 + bytes.next(), 1.0 + bytes.next(), 0.25 + bytes.next()};
    const std::array<double, 3> target{bytes.number(), bytes.number(), bytes.number()};
    program.add_block(mass, target);
  }
  for (int rows = bytes.next() % 12; rows > 0; --rows) {
    bytes.next() % 4 == 0 ? program.add_equality(bytes.number())
                          : program.add_inequality(bytes.number());
    const int first = bytes.next() % blocks;
    for (int block = first; block < std::min(blocks, first + 2); ++block) {
      program.add_entry(block,
                        std::array<double, 3>{bytes.number(), bytes.number(), bytes.number()});
    }
  }
  return program;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const QuadraticProgram program = program_of(bytes);
  bool optimal = false;
  bool infeasible = false;
  for (const QpMethod method : {QpMethod::automatic, QpMethod::newton, QpMethod::interior_point}) {
    QpResult result;
    make_qp_solver(method)->solve(program, result);
    optimal = optimal || result.status == QpStatus::optimal;
    infeasible = infeasible || result.status == QpStatus::infeasible;
    if (result.status == QpStatus::optimal)
      fuzz::require(optimality_residual(program, result.x, result.multiplier).worst() <= 1e-9);
  }
  fuzz::require(!(optimal && infeasible));
  return 0;
}
