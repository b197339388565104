#include "core/qp/coulomb/contact_form.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/qp/block/clones.h"
#include "core/qp/block/column.h"

namespace wuerfel {
namespace {

/// K_ba += n p' + t q', columns of three
inline void add_outer(const Column& n, const Column& p, const Column& t, const Column& q, Quad* K) {
  for (int c = 0; c < 3; ++c) {
    Column sum;
    load(K[c], sum);
    sum += n * p[c];
    sum += t * q[c];
    store(sum, K[c]);
  }
}

/// Normal and tangential part side by side.
using Both = double __attribute__((vector_size(sizeof(Pair))));

/// g y
inline Pair rows_of(std::span<const ContactEntry> entries, const int* block, const Quad* y) {
  Both sum = {0.0, 0.0};
  for (const ContactEntry& entry : entries) {
    Column n;
    Column t;
    Column x;
    load(entry.n, n);
    load(entry.t, t);
    load(y[*block++], x);
    n *= x;
    t *= x;
    sum += (Both{n[0], t[0]} + Both{n[1], t[1]}) + Both{n[2], t[2]};
  }
  return {sum[0], sum[1]};
}

/// out += g' f
inline void add_forces(std::span<const ContactEntry> entries,
                       const int* block,
                       const Pair& f,
                       Quad* out) {
  if (f.n == 0.0 && f.t == 0.0) return;
  for (const ContactEntry& entry : entries) {
    Column n;
    Column t;
    Column sum;
    load(entry.n, n);
    load(entry.t, t);
    Quad& to = out[*block++];
    load(to, sum);
    sum += f.n * n + f.t * t;
    store(sum, to);
  }
}

/// Adds the blocks of a unit: those of its normal row, and what the tangential one has beyond them.
void add_blocks(const QuadraticProgram& p, const ContactUnit& unit, std::vector<int>& blocks) {
  const std::span<const int> normal = p.blocks_of(unit.normal);
  blocks.insert(blocks.end(), normal.begin(), normal.end());
  if (unit.tangent < 0) return;
  const std::span<const int> tangent = p.blocks_of(unit.tangent);
  if (std::ranges::equal(normal, tangent)) return;
  for (const int block : tangent) {
    if (std::ranges::find(normal, block) == normal.end()) blocks.push_back(block);
  }
}

}  // namespace

void ContactForm::prepare(const FrictionProgram& friction, const CoulombScales& scales) {
  blocks_ = friction.program.blocks();
  rows_ = friction.program.rows();
  gather(friction);
  if (couplings_ != graph_) plan();
  scale(friction, scales);
}

/// Units in the order of their normal rows' contacts, then the rows of no contact.
void ContactForm::gather(const FrictionProgram& friction) {
  const QuadraticProgram& p = friction.program;
  units_.clear();
  of_contact_.assign(p.bound.size(), 0);
  for (const FrictionContact& c : friction.contacts) {
    const bool single = c.tangent < 0 || c.mu == 0.0;
    of_contact_[c.normal] = 1;
    if (c.tangent >= 0) of_contact_[c.tangent] = 1;
    units_.push_back({.normal = c.normal,
                      .tangent = single ? -1 : c.tangent,
                      .mu = single ? 0.0 : c.mu,
                      .slides = single ? 0 : c.slides});
  }
  for (int row = 0; row < p.rows(); ++row) {
    if (of_contact_[row] == 0) units_.push_back({.normal = row, .equality = p.is_equality(row)});
  }
  couplings_.assign(1, blocks_);
  for (ContactUnit& unit : units_) {
    unit.first = static_cast<int>(couplings_.size());
    add_blocks(p, unit, couplings_);
    unit.last = static_cast<int>(couplings_.size());
    couplings_.push_back(-1);
  }
}

void ContactForm::plan() {
  graph_ = couplings_;
  std::vector<int> start;
  std::vector<int> neighbour;
  find_graph(start, neighbour);
  if (start != start_ || neighbour != neighbour_) {
    start_.swap(start);
    neighbour_.swap(neighbour);
    order_.clear();
    lu_.plan(blocks_, start_, neighbour_, order_);
    position_.resize(order_.size());
    for (int number = 0; number < blocks_; ++number)
      position_[order_[number]] = number;
    root_.clear();
  }
  block_.assign(couplings_.size(), -1);
  for (const ContactUnit& unit : units_) {
    for (int e = unit.first; e < unit.last; ++e)
      block_[e] = position_[couplings_[e]];
    std::sort(block_.begin() + unit.first, block_.begin() + unit.last);
  }
  place_pairs();
}

void ContactForm::find_graph(std::vector<int>& start, std::vector<int>& neighbour) const {
  // Neighbours as often as units name them, block by block.
  std::vector<int> place(blocks_ + 1, 0);
  for (const ContactUnit& unit : units_) {
    for (int a = unit.first; a < unit.last; ++a)
      place[couplings_[a] + 1] += unit.last - unit.first - 1;
  }
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<int> named(place.back());
  for (const ContactUnit& unit : units_) {
    for (int a = unit.first; a < unit.last; ++a) {
      for (int b = unit.first; b < unit.last; ++b)
        if (a != b) named[place[couplings_[a]]++] = couplings_[b];
    }
  }
  // Each place has moved to where the next one began.
  start.assign(1, 0);
  neighbour.clear();
  auto first = named.begin();
  for (int block = 0; block < blocks_; ++block) {
    const auto last = named.begin() + place[block];
    std::sort(first, last);
    std::unique_copy(first, last, std::back_inserter(neighbour));
    start.push_back(static_cast<int>(neighbour.size()));
    first = last;
  }
}

void ContactForm::place_pairs() {
  pair_.clear();
  for (const ContactUnit& unit : units_) {
    for (int a = unit.first; a < unit.last; ++a) {
      for (int b = a; b < unit.last; ++b)
        pair_.push_back(lu_.place(block_[b], block_[a]));
    }
  }
}

/// M^(-1/2), anew where masses or the order have changed.
void ContactForm::find_roots(const QuadraticProgram& p) {
  if (mass_ == p.mass && !root_.empty()) return;
  mass_ = p.mass;
  root_.assign(order_.size(), Quad{});
  for (int number = 0; number < blocks_; ++number) {
    for (int c = 0; c < p.block_size; ++c)
      root_[number].v[c] = 1.0 / std::sqrt(p.mass[order_[number] * p.block_size + c]);
  }
}

void ContactForm::scale(const FrictionProgram& friction, const CoulombScales& scales) {
  const QuadraticProgram& p = friction.program;
  find_roots(p);
  entry_.assign(block_.size(), ContactEntry{});
  double largest = 0.0;
  const double per_velocity = scales.velocity > 0.0 ? 1.0 / scales.velocity : 1.0;
  for (ContactUnit& unit : units_) {
    scale_row(p, unit.normal, false, unit);
    unit.norm.n = scales.row_norm[unit.normal];
    unit.per_velocity.n = per_velocity / unit.norm.n;
    if (unit.tangent >= 0) {
      scale_row(p, unit.tangent, true, unit);
      unit.norm.t = scales.row_norm[unit.tangent];
      unit.per_velocity.t = per_velocity / unit.norm.t;
    }
    largest = std::max({largest, unit.square.n, unit.square.t});
  }
  if (largest == 0.0) largest = 1.0;
  for (ContactUnit& unit : units_) {
    if (unit.square.n == 0.0) unit.square.n = largest;
    if (unit.square.t == 0.0) unit.square.t = largest;
    unit.compliance = {unit.square.n * std::max(1.0, unit.mu), unit.square.t};
  }
}

void ContactForm::scale_row(const QuadraticProgram& p,
                            int row,
                            bool tangential,
                            ContactUnit& unit) {
  double shift = 0.0;
  double square = 0.0;
  p.for_each_entry(row, [&](const double* J, int first, int size) {
    const int number = position_[first / size];
    int k = unit.first;
    while (block_[k] != number)
      ++k;
    Quad& g = tangential ? entry_[k].t : entry_[k].n;
    for (int c = 0; c < size; ++c) {
      const double scaled = J[c] * root_[number].v[c];
      shift += J[c] * p.target[first + c];
      square += scaled * scaled;
      g.v[c] = scaled;
    }
  });
  (tangential ? unit.h.t : unit.h.n) = p.bound[row] - shift;
  (tangential ? unit.square.t : unit.square.n) = square;
}

WUERFEL_CLONES void ContactForm::apply(const Quad* y, Pair* out) const {
  for (const ContactUnit& unit : units_)
    *out++ = rows_of(entries(unit), blocks_of(unit), y);
}

WUERFEL_CLONES void ContactForm::apply_transposed(const Pair* l, Quad* out) const {
  std::fill(out, out + blocks_, Quad{});
  for (const ContactUnit& unit : units_)
    add_forces(entries(unit), blocks_of(unit), *l++, out);
}

/// In one pass: what takes time is reading the entries.
WUERFEL_CLONES void ContactForm::respond(const std::vector<Weight>& weight,
                                         const std::vector<Pair>& right,
                                         const std::vector<Pair>* l,
                                         ContactStep& step,
                                         Quad* out) const {
  std::fill(out, out + blocks_, Quad{});
  for (int i = 0; i < count(); ++i) {
    const ContactUnit& unit = units_[i];
    const Weight& w = weight[i];
    const Pair rows = rows_of(entries(unit), blocks_of(unit), step.dy.data());
    const double n = right[i].n - rows.n;
    const Pair former = l != nullptr ? (*l)[i] : Pair{};
    const Pair sum{w.nn * n + former.n, w.tn * n + w.tt * (right[i].t - rows.t) + former.t};
    add_forces(entries(unit), blocks_of(unit), sum, out);
    step.Gdy[i] = rows;
    step.dl[i] = {sum.n - former.n, sum.t - former.t};
  }
}

Pair ContactForm::rows(int unit, const Quad* y) const {
  Pair sum;
  for (int e = units_[unit].first; e < units_[unit].last; ++e) {
    for (int c = 0; c < 3; ++c) {
      sum.n += entry_[e].n.v[c] * y[block_[e]].v[c];
      sum.t += entry_[e].t.v[c] * y[block_[e]].v[c];
    }
  }
  return sum;
}

void ContactForm::add_transposed(int unit, const Pair& l, Quad* out) const {
  for (int e = units_[unit].first; e < units_[unit].last; ++e) {
    for (int c = 0; c < 3; ++c)
      out[block_[e]].v[c] += l.n * entry_[e].n.v[c] + l.t * entry_[e].t.v[c];
  }
}

/// K_ba += g_n,b p_a' + g_t,b q_a' with p = nn g_n + nt g_t, q = tn g_n + tt g_t.
WUERFEL_CLONES bool ContactForm::factorise(const std::vector<Weight>& weight) {
  lu_.set_identity();
  const int* pair = pair_.data();
  for (int i = 0; i < count(); ++i) {
    const ContactUnit& unit = units_[i];
    const Weight& w = weight[i];
    const int size = unit.last - unit.first;
    const int* place = pair;
    pair += size * (size + 1) / 2;
    if (w.nn == 0.0 && w.tt == 0.0 && w.tn == 0.0 && w.nt == 0.0) continue;
    for (int a = unit.first; a < unit.last; ++a) {
      Column n_a;
      Column t_a;
      load(entry_[a].n, n_a);
      load(entry_[a].t, t_a);
      for (int b = a; b < unit.last; ++b, ++place) {
        Column n_b;
        Column t_b;
        load(entry_[b].n, n_b);
        load(entry_[b].t, t_b);
        add_outer(n_b, w.nn * n_a + w.nt * t_a, t_b, w.tn * n_a + w.tt * t_a, lu_.lower(*place));
        if (b == a) continue;
        add_outer(n_b, w.nn * n_a + w.tn * t_a, t_b, w.nt * n_a + w.tt * t_a, lu_.upper(*place));
      }
    }
  }
  return lu_.factorise();
}

void ContactForm::read(const QuadraticProgram& program,
                       const std::vector<Quad>& y,
                       std::vector<double>& x) const {
  x = program.target;
  for (int number = 0; number < blocks_; ++number) {
    for (int c = 0; c < program.block_size; ++c)
      x[order_[number] * program.block_size + c] += y[number].v[c] * root_[number].v[c];
  }
}

void ContactForm::write(const QuadraticProgram& program,
                        const std::vector<double>& x,
                        std::vector<Quad>& y) const {
  y.assign(blocks_, Quad{});
  for (int number = 0; number < blocks_; ++number) {
    for (int c = 0; c < program.block_size; ++c) {
      const int j = order_[number] * program.block_size + c;
      y[number].v[c] = (x[j] - program.target[j]) / root_[number].v[c];
    }
  }
}

void ContactForm::read(const std::vector<Pair>& l, std::vector<double>& multiplier) const {
  multiplier.assign(rows_, 0.0);
  for (int i = 0; i < count(); ++i) {
    multiplier[units_[i].normal] = l[i].n;
    if (units_[i].tangent >= 0) multiplier[units_[i].tangent] = l[i].t;
  }
}

}  // namespace wuerfel
