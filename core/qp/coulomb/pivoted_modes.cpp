#include "core/qp/coulomb/pivoted_modes.h"

#include <algorithm>
#include <cmath>

#include "core/qp/coulomb/contact_modes.h"

namespace wuerfel {

void PivotedModes::number(const ContactForm& form, const std::vector<ContactMode>& modes) {
  place_.assign(modes.size(), Place{});
  size_ = 3 * form.blocks();
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    Place& at = place_[i];
    at.slip = slip_sign(modes[i]);
    at.scale_n = 1.0 / std::sqrt(unit.square.n);
    at.scale_t = 1.0 / std::sqrt(unit.square.t);
    if (modes[i] != ContactMode::open) at.n = size_++;
    if (modes[i] == ContactMode::stick) at.t = size_++;
  }
}

bool PivotedModes::factorise(const ContactForm& form,
                             const std::vector<ContactMode>& modes,
                             double delta) {
  number(form, modes);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * form.blocks());
  for (int j = 0; j < 3 * form.blocks(); ++j)
    entries.emplace_back(j, j, 1.0);
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    const Place& at = place_[i];
    if (at.n < 0) continue;
    const double edge = std::max(1.0, unit.mu);
    entries.emplace_back(at.n, at.n, delta);
    if (at.t >= 0) entries.emplace_back(at.t, at.t, delta);
    const int* block = form.blocks_of(unit);
    for (const ContactEntry& e : form.entries(unit)) {
      for (int c = 0; c < 3; ++c) {
        const int y = 3 * *block + c;
        const double n = e.n.v[c] * at.scale_n;
        const double t = e.t.v[c] * at.scale_n;
        entries.emplace_back(at.n, y, n);
        entries.emplace_back(y, at.n, -(n - at.slip * unit.mu * t) / edge);
        if (at.t < 0) continue;
        entries.emplace_back(at.t, y, e.t.v[c] * at.scale_t);
        entries.emplace_back(y, at.t, -e.t.v[c] * at.scale_t);
      }
      ++block;
    }
    place_[i].scale_n /= edge;
  }
  matrix_.resize(size_, size_);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  lu_.compute(matrix_);
  return lu_.info() == Eigen::Success;
}

void PivotedModes::solve(const ContactForm& form,
                         const std::vector<Pair>& r,
                         const std::vector<Quad>& u,
                         std::vector<Quad>& dy,
                         std::vector<Pair>& dl) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size_);
  for (int j = 0; j < 3 * form.blocks(); ++j)
    right[j] = u[j / 3].v[j % 3];
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    if (place_[i].n >= 0) right[place_[i].n] = r[i].n / std::sqrt(unit.square.n);
    if (place_[i].t >= 0) right[place_[i].t] = r[i].t * place_[i].scale_t;
  }
  Eigen::VectorXd x = lu_.solve(right);
  x += lu_.solve(right - matrix_ * x);
  for (int j = 0; j < 3 * form.blocks(); ++j)
    dy[j / 3].v[j % 3] = x[j];
  for (int i = 0; i < form.count(); ++i) {
    const Place& at = place_[i];
    dl[i] = {};
    if (at.n >= 0) dl[i].n = x[at.n] * at.scale_n;
    dl[i].t = at.t >= 0 ? x[at.t] * at.scale_t : -at.slip * form.units()[i].mu * dl[i].n;
  }
}

}  // namespace wuerfel
