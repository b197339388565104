/// How far the inner stages are from what the machine allows.
///
///     build/release/tests/limits_benchmark
///
/// First the machine: multiplications and additions of doubles per second in one core (AVX2,
/// separate instructions, as our bits do not allow fused ones), and bytes per second read from the
/// second-level cache and from memory. Then each stage: the work counted, the time that the machine
/// needs for that work at least, and the time measured. Prints Markdown.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/qp/block/block_cholesky.h"
#include "core/qp/qp_solver.h"
#include "core/qp/residual_meter.h"
#include "render/files/png.h"
#include "tests/benchmark/bench/clock.h"
#include "tests/support/qp_zoo.h"

namespace {

using namespace wuerfel;

constexpr double budget = 0.3;  // s for each figure

struct Machine {
  double flops = 0.0;         ///< 1/s
  double cache_bytes = 0.0;   ///< 1/s, read from the second-level cache
  double memory_bytes = 0.0;  ///< 1/s, read from memory
};

using Wide = double __attribute__((vector_size(32)));

// Independent chains, enough to hide the latency of both units.
__attribute__((target("avx2"))) double multiply_and_add(long rounds) {
  constexpr int chains = 12;
  std::array<Wide, chains> sum{};
  const Wide a{1.0, 0.5, 0.25, 0.125};
  const Wide b{0.999, 0.998, 0.997, 0.996};
  for (long k = 0; k < rounds; ++k) {
    for (Wide& s : sum)
      s = s * b + a;
  }
  double total = 0.0;
  for (const Wide& s : sum)
    total += s[0] + s[1] + s[2] + s[3];
  return total;
}

double measured_flops() {
  constexpr long rounds = 200'000;
  volatile double keep = 0.0;
  const double seconds = best_time(budget, [&] { keep = keep + multiply_and_add(rounds); }).seconds;
  return static_cast<double>(rounds) * 12 * 8 / seconds;
}

__attribute__((target("avx2"))) double add_up(const std::vector<double>& numbers) {
  std::array<Wide, 8> sum{};
  const double* p = numbers.data();
  const double* end = p + numbers.size();
  for (; p < end; p += 32) {
    for (std::size_t k = 0; k < 8; ++k) {
      Wide w;
      std::memcpy(&w, p + 4 * k, sizeof w);
      sum[k] += w;
    }
  }
  double total = 0.0;
  for (const Wide& s : sum)
    total += s[0] + s[1] + s[2] + s[3];
  return total;
}

double measured_bandwidth(std::size_t bytes) {
  const std::vector<double> numbers(bytes / sizeof(double), 1.0);
  volatile double keep = 0.0;
  const double seconds = best_time(budget, [&] { keep = keep + add_up(numbers); }).seconds;
  return static_cast<double>(bytes) / seconds;
}

// The rows of a program as the kernels want them, numbered by the order of elimination.
struct Rows {
  std::vector<int> start, block, pair;
  std::vector<Quad> g;

  [[nodiscard]] BlockRows view(int blocks) const {
    return {static_cast<int>(start.size()) - 1,
            blocks,
            start.data(),
            block.data(),
            g.data(),
            pair.data()};
  }
};

void couple(const QuadraticProgram& program, std::vector<int>& start, std::vector<int>& neighbour) {
  std::vector<std::vector<int>> near(program.blocks());
  for (int row = 0; row < program.rows(); ++row) {
    const auto first = program.entry_block.begin() + program.row_start[row];
    const auto last = program.entry_block.begin() + program.row_start[row + 1];
    for (auto a = first; a != last; ++a) {
      for (auto b = first; b != last; ++b)
        if (a != b) near[*a].push_back(*b);
    }
  }
  start.assign(1, 0);
  for (std::vector<int>& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    neighbour.insert(neighbour.end(), list.begin(), list.end());
    start.push_back(static_cast<int>(neighbour.size()));
  }
}

Rows gather(const QuadraticProgram& program,
            const BlockCholesky& factor,
            const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    position[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  Rows rows;
  rows.start.push_back(0);
  for (std::size_t i = 0; i + 1 < program.row_start.size(); ++i) {
    std::vector<std::pair<int, int>> entries;  // place in the order, entry
    for (int e = program.row_start[i]; e < program.row_start[i + 1]; ++e) {
      const int block = program.entry_block[static_cast<std::size_t>(e)];
      entries.emplace_back(position[static_cast<std::size_t>(block)], e);
    }
    std::sort(entries.begin(), entries.end());
    for (std::size_t a = 0; a < entries.size(); ++a) {
      const auto values = program.entry(entries[a].second);
      rows.block.push_back(entries[a].first);
      rows.g.push_back({{values[0], values[1], values[2], 0.0}});
      for (std::size_t b = a; b < entries.size(); ++b)
        rows.pair.push_back(factor.place(entries[b].first, entries[a].first));
    }
    rows.start.push_back(static_cast<int>(rows.block.size()));
  }
  return rows;
}

// Multiplications and additions of the numeric factorisation: for every column with n blocks below
// the diagonal, n (n + 1) / 2 products of 3x3 blocks, n triangular solves, one 3x3 factorisation.
double factor_work(const BlockCholesky& factor) {
  double work = 0.0;
  for (int column = 0; column < factor.blocks(); ++column) {
    double below = 0.0;
    for (int row = column + 1; row < factor.blocks(); ++row)
      if (factor.place(row, column) >= 0) below += 1.0;
    work += 54.0 * below * (below + 1.0) / 2.0 + 27.0 * below + 22.0;
  }
  return work;
}

void print(const std::string& stage, const std::string& work, double floor, double seconds) {
  std::printf("| %s | %s | %.3g us | %.3g us | %.2g |\n", stage.c_str(), work.c_str(), floor * 1e6,
              seconds * 1e6, seconds / floor);
  std::fflush(stdout);
}

std::string count_text(double count, const char* unit) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.3g %s", count, unit);
  return text.data();
}

void print_factorisation(const std::string& name,
                         const QuadraticProgram& program,
                         const Machine& machine) {
  std::vector<int> start;
  std::vector<int> neighbour;
  std::vector<int> order;
  couple(program, start, neighbour);
  BlockCholesky factor(best_block_kernels());
  factor.plan(program.blocks(), start, neighbour, order);
  const Rows rows = gather(program, factor, order);
  const std::vector<double> weight(static_cast<std::size_t>(program.rows()), 1.0);
  const BlockRows view = rows.view(program.blocks());
  const double seconds = best_time(budget, [&] { factor.factorise(view, weight.data()); }).seconds;
  // Assembling: a product and a sum of 3x3 for each pair of entries.
  const double work = factor_work(factor) + 27.0 * static_cast<double>(rows.pair.size());
  print(name + ": assemble and factorise", count_text(work, "flops"), work / machine.flops,
        seconds);
  std::vector<Quad> v(static_cast<std::size_t>(program.blocks()), Quad{{1.0, 1.0, 1.0, 0.0}});
  const double bytes = 2.0 * 96.0 * factor.fill();  // every block of L once down and once up
  const double solving = best_time(budget, [&] { factor.solve(v.data()); }).seconds;
  print(name + ": solve with the factor", count_text(bytes, "bytes"), bytes / machine.cache_bytes,
        solving);
  const auto solver = make_qp_solver(QpMethod::automatic);
  QpResult result;
  solver->solve(program, result);
  const double whole = best_time(budget, [&] { solver->solve(program, result); }).seconds;
  print(name + ": the same program again", count_text(result.iterations * work, "flops"),
        std::max(1, result.iterations) * work / machine.flops, whole);
}

void print_certificate(const Machine& machine) {
  const QuadraticProgram program = test::tower(1000);
  const auto solver = make_qp_solver(QpMethod::automatic);
  QpResult result;
  solver->solve(program, result);
  ResidualMeter meter;
  meter.measure_scales(program);
  const double seconds = best_time(budget, [&] {
                           static_cast<void>(meter.measure(program, result.x, result.multiplier));
                         }).seconds;
  const double rows = program.rows();
  const double entries = program.entries();
  // Per row bound, range, multiplier, norm, start; per entry block and three coefficients, twice (J
  // and J'); per unknown mass, target, x, scale.
  const double bytes = 44.0 * rows + 2.0 * 28.0 * entries + 32.0 * program.unknowns();
  print("tower 1000: is the old answer still one?", count_text(bytes, "bytes"),
        bytes / machine.cache_bytes, seconds);
}

void print_deflate(const Machine& machine) {
  Image image(1280, 720);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      if ((x / 160 + y / 120) % 3 == 0) image.set(x, y, {0, 114, 178, 255});
  }
  ImageCompressor compressor;
  CompressedImage compressed;
  const double seconds =
      best_time(budget, [&] { compressor.compress(image, PngChannels::rgb, compressed); }).seconds;
  const double read = static_cast<double>(image.bytes().size());
  print("deflate of a flat picture, 1280 x 720", count_text(read, "bytes"),
        read / machine.memory_bytes, seconds);
}

}  // namespace

int main() {
  Machine machine;
  machine.flops = measured_flops();
  machine.cache_bytes = measured_bandwidth(std::size_t{1} << 18U);
  machine.memory_bytes = measured_bandwidth(std::size_t{1} << 28U);
  std::printf("machine, one core: %.3g Gflop/s, %.3g GB/s from cache, %.3g GB/s from memory\n\n",
              machine.flops * 1e-9, machine.cache_bytes * 1e-9, machine.memory_bytes * 1e-9);
  std::printf("| stage | work | the machine's least | measured | times the least |\n");
  std::printf("|---|---|---|---|---|\n");
  print_factorisation("tower 1000", test::tower(1000), machine);
  print_factorisation("pile 1000", test::pile(1000), machine);
  print_factorisation("wall 30 x 30", test::wall(30, 30), machine);
  print_certificate(machine);
  print_deflate(machine);
  return 0;
}
