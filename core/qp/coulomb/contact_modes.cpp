#include "core/qp/coulomb/contact_modes.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/quad_vector.h"
#include "core/qp/refinement.h"

namespace wuerfel {
namespace {

constexpr int most_cheap_blocks = 32;  ///< whose factors cost no more than terms of rank one

}  // namespace

void ContactPoint::reset(const ContactForm& form) {
  y.assign(form.blocks(), Quad{});
  l.assign(form.count(), Pair{});
  rest.resize(form.count());
  for (int i = 0; i < form.count(); ++i)
    rest[i] = form.units()[i].h;
}

void ContactPoint::recompute(const ContactForm& form) {
  form.apply_transposed(l.data(), y.data());
  form.apply(y.data(), rest.data());
  for (int i = 0; i < form.count(); ++i) {
    const Pair& h = form.units()[i].h;
    rest[i] = {h.n - rest[i].n, h.t - rest[i].t};
  }
}

void ContactPoint::move(double length, const ContactStep& step) {
  for (std::size_t i = 0; i < l.size(); ++i) {
    l[i].n += length * step.dl[i].n;
    l[i].t += length * step.dl[i].t;
    rest[i].n -= length * step.Gdy[i].n;
    rest[i].t -= length * step.Gdy[i].t;
  }
  add(length, step.dy, y);
}

double largest_force(const ContactForm& form, const std::vector<Pair>& l) {
  double force = 0.0;
  for (int i = 0; i < form.count(); ++i) {
    const Pair& norm = form.units()[i].norm;
    force = std::max({force, std::abs(l[i].n) * norm.n, std::abs(l[i].t) * norm.t});
  }
  return force;
}

double largest_normal_force(const ContactForm& form, const std::vector<Pair>& l) {
  double force = 0.0;
  for (int i = 0; i < form.count(); ++i)
    force = std::max(force, l[i].n * form.units()[i].norm.n);
  return force;
}

double missed_by(const ContactForm& form,
                 const std::vector<ContactMode>& modes,
                 const ContactPoint& point) {
  double missed = 0.0;
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    if (modes[i] != ContactMode::open)
      missed = std::max(missed, std::abs(point.rest[i].n) * unit.per_velocity.n);
    if (modes[i] == ContactMode::stick)
      missed = std::max(missed, std::abs(point.rest[i].t) * unit.per_velocity.t);
  }
  return missed;
}

void Crossing::meet(double value, double rate, int other, ContactMode mode) {
  if (rate >= 0.0) return;
  const double sooner = std::max(value, 0.0) / -rate;
  if (sooner < step) *this = {sooner, other, mode};
}

void Crossing::meet_cone(
    const ContactUnit& contact, ContactMode mode, const Pair& l, const Pair& dl, int other) {
  if (mode != ContactMode::stick) {
    meet(l.n, dl.n, other, ContactMode::open);
    return;
  }
  meet(contact.mu * l.n - l.t, contact.mu * dl.n - dl.t, other, ContactMode::slip_back);
  meet(contact.mu * l.n + l.t, contact.mu * dl.n + dl.t, other, ContactMode::slip_forward);
}

ContactForm::Weight ModeSystem::weight_of(const ContactUnit& unit, ContactMode mode) const {
  ContactForm::Weight w;
  if (mode != ContactMode::open) w.nn = 1.0 / (delta_ * unit.compliance.n);
  if (mode == ContactMode::stick) w.tt = 1.0 / (delta_ * unit.compliance.t);
  w.tn = -slip_sign(mode) * unit.mu * w.nn;
  return w;
}

bool ModeSystem::factorise(ContactForm& form,
                           const std::vector<ContactMode>& modes,
                           double delta,
                           Pivoting pivoting) {
  pivoting_ = pivoting;
  delta_ = delta;
  terms_.clear();
  if (pivoting == Pivoting::full) return pivoted_.factorise(form, modes, delta);
  weight_.resize(modes.size());
  for (int i = 0; i < form.count(); ++i)
    weight_[i] = weight_of(form.units()[i], modes[i]);
  return form.factorise(weight_);
}

/// The difference is of rank one, but where an open contact sticks at once or the other way round.
bool ModeSystem::change(ContactForm& form, const std::vector<ContactMode>& modes, int unit) {
  if (pivoting_ == Pivoting::none && form.blocks() > most_cheap_blocks) {
    const ContactForm::Weight w = weight_of(form.units()[unit], modes[unit]);
    const double nn = w.nn - weight_[unit].nn;
    const double tn = w.tn - weight_[unit].tn;
    const double tt = w.tt - weight_[unit].tt;
    weight_[unit] = w;
    if (tt == 0.0 && terms_.add(form, unit, {nn, tn}, {1.0, 0.0})) return true;
    if (tt != 0.0 && nn == 0.0 && terms_.add(form, unit, {0.0, 1.0}, {tn, tt})) return true;
  }
  return factorise(form, modes, delta_, pivoting_);
}

void ModeSystem::solve(const ContactForm& form,
                       const std::vector<Pair>& r,
                       const std::vector<Quad>& u,
                       double balance) {
  auto& [dy, dl, Gdy] = step_;
  dl.resize(r.size());
  Gdy.resize(r.size());
  dy.assign(u.size(), Quad{});
  if (pivoting_ == Pivoting::full) {
    pivoted_.solve(form, r, u, dy, dl);
    form.apply(dy.data(), Gdy.data());
    return;
  }
  u_.resize(u.size());
  for (int i = 0; i < form.count(); ++i) {
    const ContactForm::Weight& w = weight_[i];
    dl[i] = {w.nn * r[i].n, w.tn * r[i].n + w.tt * r[i].t};
  }
  form.apply_transposed(dl.data(), u_.data());
  add(1.0, u, u_);
  terms_.solve(form, u_);
  dy = u_;
  form.respond(weight_, r, nullptr, step_, u_.data());
  refine(form, r, u, balance);
}

void ModeSystem::solve_again(const ContactForm& form,
                             const std::vector<Pair>& r,
                             const std::vector<Quad>& u,
                             int unit,
                             double balance) {
  const Pair& rows = step_.Gdy[unit];
  terms_.correct(form, {r[unit].n - rows.n, r[unit].t - rows.t}, step_.dy);
  form.respond(weight_, r, nullptr, step_, u_.data());
  refine(form, r, u, balance);
}

void ModeSystem::refine(const ContactForm& form,
                        const std::vector<Pair>& r,
                        const std::vector<Quad>& u,
                        double balance) {
  std::vector<Quad>& dy = step_.dy;
  double former = unbounded;
  for (int round = 0; round < most_refinements; ++round) {
    double size = 0.0;
    double missed = 0.0;
    for (std::size_t b = 0; b < u.size(); ++b) {
      for (int c = 0; c < 3; ++c) {
        u_[b].v[c] += u[b].v[c] - dy[b].v[c];
        missed = std::max(missed, std::abs(u_[b].v[c]));
        size = std::max(size, std::abs(dy[b].v[c]));
      }
    }
    if (missed <= balance * size || !(missed < 0.5 * former)) break;
    former = missed;
    terms_.solve(form, u_);
    add(1.0, u_, dy);
    form.respond(weight_, r, nullptr, step_, u_.data());
  }
}

void follow_mode(const ContactUnit& unit, ContactMode mode, Pair& l) {
  if (mode == ContactMode::open) l = {};
  if (unit.equality) return;
  l.n = std::max(l.n, 0.0);
  const double s = slip_sign(mode);
  const double most = unit.mu * l.n;
  l.t = s != 0.0 ? -s * most : std::clamp(l.t, -most, most);
}

void clamp_to_cone(const ContactUnit& unit, Pair& l) {
  if (unit.equality) return;
  l.n = std::max(l.n, 0.0);
  const double most = unit.mu * l.n;
  l.t = unit.slides != 0 ? -unit.slides * most : std::clamp(l.t, -most, most);
}

}  // namespace wuerfel
