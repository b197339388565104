/// Once a solver has seen a program it solves others of the same shape without touching the heap.
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "core/qp/qp_solver.h"
#include "tests/support/qp_zoo.h"

namespace {
// Counts every allocation of this program; the only way to see those inside of the solver.
std::size_t allocations = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = nullptr;
  if (posix_memalign(&memory, alignment, size > 0 ? size : 1) != 0) throw std::bad_alloc();
  return memory;
}
}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
// NOLINTBEGIN(cppcoreguidelines-no-malloc)
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t /*alignment*/) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
void operator delete[](void* memory,
                       std::size_t /*size*/,
                       std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc)

namespace wuerfel::test {
namespace {

std::vector<QuadraticProgram> steps_of(int kind) {
  std::vector<QuadraticProgram> programs;
  for (std::uint64_t step = 0; step < 40; ++step) {
    ZooOptions options{.shift = 1e-3, .turn = 3e-4};
    options.step = step;
    if (kind == 0) programs.push_back(tower(20, options));
    if (kind == 1) programs.push_back(pile(120, options));
    if (kind == 2) programs.push_back(wall(5, 5, options));
  }
  return programs;
}

class Allocation : public testing::TestWithParam<QpMethod> {};

TEST_P(Allocation, DoesNotHappenAfterTheFirstSolves) {
  for (int kind = 0; kind < 3; ++kind) {
    const std::vector<QuadraticProgram> programs = steps_of(kind);
    const auto solver = make_qp_solver(GetParam());
    QpResult result;
    // The first pass lets every method come to its turn.
    for (const QuadraticProgram& program : programs)
      solver->solve(program, result);
    const std::size_t before = allocations;
    EXPECT_GT(before, 0U);
    for (const QuadraticProgram& program : programs)
      solver->solve(program, result);
    EXPECT_EQ(allocations, before) << "kind " << kind;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Methods,
    Allocation,
    testing::Values(QpMethod::automatic, QpMethod::newton, QpMethod::interior_point),
    [](const auto& test_case) {
      return test_case.param == QpMethod::interior_point ? std::string("interior_point")
                                                         : std::string(to_string(test_case.param));
    });

}  // namespace
}  // namespace wuerfel::test
