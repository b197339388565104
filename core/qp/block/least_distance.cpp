#include "core/qp/block/least_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wuerfel {
namespace {

constexpr int three = 3;

}  // namespace

void LeastDistance::forget() {
  planned_ = false;
  row_start_.clear();
  entry_block_.clear();
}

void LeastDistance::prepare(const QuadraticProgram& program) {
  same_rows_ = has_same_rows(program);
  if (!same_rows_) {
    match_rows(program);
    const int parts = (program.block_size + three - 1) / three;
    const int blocks = program.blocks() * parts;
    planned_ = planned_ && blocks == blocks_ && program.block_size == block_size_;
    block_size_ = program.block_size;
    parts_ = parts;
    blocks_ = blocks;
    rows_ = program.rows();
    row_start_ = program.row_start;
    entry_block_ = program.entry_block;
    if (planned_) number_entries();
    if (!planned_ || !place_pairs()) plan();
    mass_.clear();
  }
  scale(program);
}

bool LeastDistance::has_same_rows(const QuadraticProgram& program) const {
  return planned_ && program.block_size == block_size_ && program.blocks() * parts_ == blocks_
         && program.row_start == row_start_ && program.entry_block == entry_block_;
}

/// Pairs rows of equal blocks in one pass over both lists, which contact searches leave in the same
/// order.
void LeastDistance::match_rows(const QuadraticProgram& program) {
  constexpr int farthest = 16;
  former_start_.swap(row_start_);
  former_block_.swap(entry_block_);
  const int former_rows = static_cast<int>(former_start_.size()) - 1;
  const auto same = [&](int row, int former) {
    return std::equal(program.entry_block.begin() + program.row_start[row],
                      program.entry_block.begin() + program.row_start[row + 1],
                      former_block_.begin() + former_start_[former],
                      former_block_.begin() + former_start_[former + 1]);
  };
  former_row_.assign(program.bound.size(), -1);
  int next = 0;
  for (int row = 0; row < program.rows(); ++row) {
    for (int former = next; former < std::min(former_rows, next + farthest); ++former) {
      if (same(row, former)) {
        former_row_[row] = former;
        next = former + 1;
        break;
      }
    }
  }
}

/// Rows in elimination numbers, each with increasing blocks.
void LeastDistance::number_entries() {
  start_.resize(rows_ + 1);
  start_[0] = 0;
  block_.resize(entry_block_.size() * parts_);
  source_.resize(block_.size());
  for (int row = 0; row < rows_; ++row) {
    const int first = row_start_[row] * parts_;
    const int last = row_start_[row + 1] * parts_;
    start_[row + 1] = last;
    for (int k = first; k < last; ++k) {
      const int number = position_[entry_block_[k / parts_] * parts_ + k % parts_];
      int place = k;
      for (; place > first && block_[place - 1] > number; --place) {
        block_[place] = block_[place - 1];
        source_[place] = source_[place - 1];
      }
      block_[place] = number;
      source_[place] = k;
    }
  }
}

/// Finds where the outer products of the rows go. False if they do not fit the plan, or leave most
/// of it empty.
bool LeastDistance::place_pairs() {
  pair_.clear();
  for (int row = 0; row < rows_; ++row) {
    for (int a = start_[row]; a < start_[row + 1]; ++a) {
      for (int b = a; b < start_[row + 1]; ++b) {
        const int place = cholesky_.place(block_[b], block_[a]);
        if (place < 0) return false;
        pair_.push_back(place);
      }
    }
  }
  return 2 * pair_.size() >= planned_pairs_;
}

void LeastDistance::plan() {
  find_graph();
  cholesky_.plan(blocks_, graph_start_, graph_, order_);
  position_.resize(blocks_);
  for (int number = 0; number < blocks_; ++number)
    position_[order_[number]] = number;
  planned_ = true;
  planned_pairs_ = 0;
  number_entries();
  place_pairs();
  planned_pairs_ = pair_.size();
}

/// Which threes meet in a row, each coupling listed at both and once.
void LeastDistance::find_graph() {
  graph_start_.assign(blocks_ + 1, 0);
  const auto for_all_couplings = [&](auto&& visit) {
    const auto three = [this](int part) {
      return entry_block_[part / parts_] * parts_ + part % parts_;
    };
    for (int row = 0; row < rows_; ++row) {
      const int first = row_start_[row] * parts_;
      const int last = row_start_[row + 1] * parts_;
      for (int a = first; a < last; ++a) {
        for (int b = first; b < last; ++b)
          if (a != b) visit(three(a), three(b));
      }
    }
  };
  for_all_couplings([&](int a, int /*b*/) { ++graph_start_[a + 1]; });
  std::partial_sum(graph_start_.begin(), graph_start_.end(), graph_start_.begin());
  graph_.resize(graph_start_.back());
  order_.assign(graph_start_.begin(), graph_start_.end());
  for_all_couplings([&](int a, int b) { graph_[order_[a]++] = b; });
  // Repeated couplings are squeezed out in place.
  auto to = graph_.begin();
  for (int block = 0; block < blocks_; ++block) {
    const auto first = graph_.begin() + graph_start_[block];
    const auto last = graph_.begin() + graph_start_[block + 1];
    graph_start_[block] = static_cast<int>(to - graph_.begin());
    std::sort(first, last);
    to = std::copy(first, std::unique(first, last), to);
  }
  graph_start_.back() = static_cast<int>(to - graph_.begin());
  graph_.erase(to, graph_.end());
}

void LeastDistance::scale(const QuadraticProgram& program) {
  if (mass_ != program.mass) scale_masses(program);
  force_min_ = program.force_min;
  force_max_ = program.force_max;
  g_.resize(block_.size());
  h_.resize(rows_);
  square_.resize(rows_);
  if (block_size_ == three) {
    scale_threes(program);
  } else {
    for (int row = 0; row < rows_; ++row)
      scale_row(program, row);
  }
  view_ = {rows_, blocks_, start_.data(), block_.data(), g_.data(), pair_.data()};
}

void LeastDistance::scale_masses(const QuadraticProgram& program) {
  mass_ = program.mass;
  root_.assign(blocks_, Quad{});
  for (int number = 0; number < blocks_; ++number) {
    const int block = order_[number] / parts_;
    const int part = order_[number] % parts_;
    for (int c = 0; c < std::min(three, block_size_ - three * part); ++c) {
      root_[number].v[c] = 1.0 / std::sqrt(program.mass[block * block_size_ + three * part + c]);
    }
  }
}

/// scale_row for all rows where nothing is padded or cut.
void LeastDistance::scale_threes(const QuadraticProgram& program) {
  const double* coefficients = program.coefficients.data();
  const double* target = program.target.data();
  for (std::size_t row = 0; row < h_.size(); ++row) {
    double shift = 0.0;
    double square = 0.0;
    for (auto k = start_[row]; k < start_[row + 1]; ++k) {
      const auto entry = source_[k];
      const double* J = coefficients + three * entry;
      const double* f = target + three * entry_block_[entry];
      const double* root = root_[block_[k]].v;
      const Quad g{{J[0] * root[0], J[1] * root[1], J[2] * root[2], 0.0}};
      shift += J[0] * f[0] + J[1] * f[1] + J[2] * f[2];
      square += g.v[0] * g.v[0] + g.v[1] * g.v[1] + g.v[2] * g.v[2];
      g_[k] = g;
    }
    h_[row] = program.bound[row] - shift;
    square_[row] = square;
  }
}

void LeastDistance::scale_row(const QuadraticProgram& program, int row) {
  double shift = 0.0;
  double square = 0.0;
  for (int k = start_[row]; k < start_[row + 1]; ++k) {
    const int entry = source_[k] / parts_;
    const int part = source_[k] % parts_;
    const int width = parts_ == 1 ? block_size_ : std::min(three, block_size_ - three * part);
    const double* J = program.coefficients.data() + entry * block_size_ + three * part;
    const double* f = program.target.data() + entry_block_[entry] * block_size_ + three * part;
    const double* root = root_[block_[k]].v;
    Quad g{};
    for (int c = 0; c < width; ++c) {
      shift += J[c] * f[c];
      g.v[c] = J[c] * root[c];
      square += g.v[c] * g.v[c];
    }
    g_[k] = g;
  }
  h_[row] = program.bound[row] - shift;
  square_[row] = square;
}

double LeastDistance::force_of(const std::vector<Quad>& unbalance) const {
  double force = 0.0;
  for (std::size_t b = 0; b < unbalance.size(); ++b) {
    const double* u = unbalance[b].v;
    force =
        std::max(force, std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])}) / root_[b].v[0]);
  }
  return force;
}

void LeastDistance::pack(const std::vector<double>& force, std::vector<Quad>& y) const {
  y.assign(blocks_, Quad{});
  for (int number = 0; number < blocks_; ++number) {
    const int block = order_[number] / parts_;
    const int part = order_[number] % parts_;
    for (int c = 0; c < std::min(three, block_size_ - three * part); ++c)
      y[number].v[c] = force[block * block_size_ + three * part + c] * root_[number].v[c];
  }
}

void LeastDistance::read(const QuadraticProgram& program,
                         const std::vector<Quad>& y,
                         std::vector<double>& x) const {
  x = program.target;
  for (int number = 0; number < blocks_; ++number) {
    const int block = order_[number] / parts_;
    const int part = order_[number] % parts_;
    for (int c = 0; c < std::min(three, block_size_ - three * part); ++c)
      x[block * block_size_ + three * part + c] += y[number].v[c] * root_[number].v[c];
  }
}

}  // namespace wuerfel
