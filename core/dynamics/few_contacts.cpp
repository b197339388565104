#include "core/dynamics/few_contacts.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

/// A pivot below this share of its diagonal belongs to a row that depends on those before it.
constexpr double dependent_share = 1e-11;

/// Residuals are refined to this share of the bounds and of J f.
constexpr double refined_share = 4e-16;
constexpr int most_refinements = 3;

int number_in(const Island& island, int cube) {
  return static_cast<int>(std::ranges::find(island.cubes, cube) - island.cubes.begin());
}

double weighted(const std::array<double, 3>& g,
                const std::array<double, 3>& h,
                const std::array<double, 3>& w) {
  return g[0] * h[0] * w[0] + g[1] * h[1] * w[1] + g[2] * h[2] * w[2];
}

}  // namespace

void FewContacts::build(const System& system,
                        const State& state,
                        const Island& island,
                        Order order) {
  inverse_mass_.clear();
  target_.clear();
  for (const int cube : island.cubes) {
    const Body& body = system.body(cube);
    const BodyState& s = state[cube];
    inverse_mass_.push_back({1.0 / body.mass, 1.0 / body.mass, 1.0 / body.inertia});
    Triple target{};
    if (order == Order::velocity) target = {s.velocity.x(), s.velocity.y(), s.spin};
    if (order == Order::acceleration) target = {system.gravity.x(), system.gravity.y(), 0.0};
    target_.insert(target_.end(), target.begin(), target.end());
  }
  count_ = 0;
  for (const Contact& contact : island.contacts)
    add(system, state, island, contact, order);
}

void FewContacts::add(
    const System& system, const State& state, const Island& island, const Contact& c, Order order) {
  const ContactRow both = pull_back(system, state, c, order, normal_row(system, state, c, order));
  rows_[count_++] = {system.is_cube(c.on) ? number_in(island, c.on) : -1,
                     system.is_cube(c.from) ? number_in(island, c.from) : -1, both.on, both.from,
                     -both.c};
}

double FewContacts::product(const Row& row, const std::vector<double>& x) const {
  double sum = 0.0;
  const auto add = [&](int cube, const Triple& g) {
    if (cube < 0) return;
    const double* at = x.data() + 3 * cube;
    sum += g[0] * at[0] + g[1] * at[1] + g[2] * at[2];
  };
  add(row.on, row.g_on);
  add(row.from, row.g_from);
  return sum;
}

double FewContacts::coupling(const Row& a, const Row& b) const {
  double sum = 0.0;
  const auto add = [&](int cube, const Triple& g, int other, const Triple& h) {
    if (cube >= 0 && cube == other) sum += weighted(g, h, inverse_mass_[cube]);
  };
  add(a.on, a.g_on, b.on, b.g_on);
  add(a.on, a.g_on, b.from, b.g_from);
  add(a.from, a.g_from, b.on, b.g_on);
  add(a.from, a.g_from, b.from, b.g_from);
  return sum;
}

/// J M^-1 J' = L L'; false where a row depends on those before it.
bool FewContacts::factorise() {
  for (int i = 0; i < count_; ++i) {
    double* row = &factor_[i * most];
    double squares = 0.0;
    for (int j = 0; j < i; ++j) {
      const double* other = &factor_[j * most];
      double sum = coupling(rows_[i], rows_[j]);
      for (int k = 0; k < j; ++k)
        sum -= row[k] * other[k];
      row[j] = sum * inverse_[j];
      squares += row[j] * row[j];
    }
    const Row& self = rows_[i];
    const double diagonal = coupling(self, self);
    const double pivot = diagonal - squares;
    if (!(pivot > dependent_share * diagonal)) return false;
    row[i] = std::sqrt(pivot);
    inverse_[i] = 1.0 / row[i];
  }
  return true;
}

void FewContacts::substitute(std::array<double, most>& r) const {
  for (int i = 0; i < count_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int j = 0; j < i; ++j)
      r[at] -= factor_[i * most + j] * r[j];
    r[at] *= inverse_[at];
  }
  for (int i = count_ - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    r[at] *= inverse_[at];
    for (int j = 0; j < i; ++j)
      r[j] -= factor_[i * most + j] * r[at];
  }
}

bool FewContacts::solve(std::vector<double>& x, std::vector<double>& multiplier) {
  if (!factorise()) return false;
  x = target_;
  multiplier.assign(count_, 0.0);
  std::array<double, most> residual{};
  double scale = 0.0;
  for (int round = 0; round <= most_refinements; ++round) {
    double worst = 0.0;
    for (std::size_t i = 0; i < multiplier.size(); ++i) {
      const double reached = product(rows_[i], x);
      residual[i] = rows_[i].bound - reached;
      if (round == 0) scale = std::max({scale, std::abs(rows_[i].bound), std::abs(reached)});
      worst = std::max(worst, std::abs(residual[i]));
    }
    if (worst <= refined_share * scale) break;
    substitute(residual);
    for (std::size_t i = 0; i < multiplier.size(); ++i) {
      multiplier[i] += residual[i];
      const auto push = [&](int cube, const Triple& g) {
        if (cube < 0) return;
        const Triple& w = inverse_mass_[cube];
        double* at = x.data() + 3 * cube;
        for (std::size_t k = 0; k < 3; ++k)
          at[k] += g[k] * w[k] * residual[i];
      };
      push(rows_[i].on, rows_[i].g_on);
      push(rows_[i].from, rows_[i].g_from);
    }
  }
  return true;
}

}  // namespace wuerfel
