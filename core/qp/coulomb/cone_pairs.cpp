#include "core/qp/coulomb/cone_pairs.h"

#include <algorithm>

#include "core/qp/interior_step.h"

namespace wuerfel {
namespace {

/// Units, at most so many and a twentieth of all, that may be left behind.
constexpr std::size_t few = 8;
constexpr std::size_t few_of = 20;

double step_length(const ConePairs& p, const ConePairsStep& d) {
  double longest = 1.0 / to_the_boundary;
  for (int k = 0; k < p.count; ++k) {
    if (d.force[k] < 0.0) longest = std::min(longest, -p.force[k] / d.force[k]);
    if (d.slack[k] < 0.0) longest = std::min(longest, -p.slack[k] / d.slack[k]);
  }
  return std::min(1.0, to_the_boundary * longest);
}

}  // namespace

/// Of force times slack over weight, after so much of the step.
double mean_product(const ConeIterate& at, const ConeDirection& step, double length) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < at.pairs.size(); ++i) {
    const ConePairs& p = at.pairs[i];
    const ConePairsStep& d = step.pairs[i];
    for (int k = 0; k < p.count; ++k) {
      sum += (p.force[k] + length * d.force[k]) * (p.slack[k] + length * d.slack[k]) / p.weight[k];
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

double step_length(const ConeIterate& at, const ConeDirection& step) {
  double length = 1.0;
  for (std::size_t i = 0; i < at.pairs.size(); ++i)
    length = std::min(length, step_length(at.pairs[i], step.pairs[i]));
  return length;
}

double step_length_of_most(const ConeIterate& at, const ConeDirection& step) {
  std::vector<double> lengths(at.pairs.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
    lengths[i] = step_length(at.pairs[i], step.pairs[i]);
  const auto first =
      lengths.begin() + static_cast<std::ptrdiff_t>(std::min(few, lengths.size() / few_of));
  std::ranges::nth_element(lengths, first);
  return *first;
}

void move(double length, const ConeDirection& step, ConeIterate& at) {
  const double tau = mean_product(at, step, 0.0);
  at.point.move(length, step.point);
  for (std::size_t i = 0; i < at.pairs.size(); ++i) {
    ConePairs& p = at.pairs[i];
    const double mine = std::min(length, step_length(p, step.pairs[i]));
    for (int k = 0; k < p.count; ++k) {
      p.force[k] += mine * step.pairs[i].force[k];
      p.slack[k] += mine * step.pairs[i].slack[k];
      if (mine < length) p.slack[k] = std::max(p.slack[k], p.weight[k] * tau / p.force[k]);
    }
    at.point.l[i].n += (mine - length) * step.point.dl[i].n;
    at.point.l[i].t += (mine - length) * step.point.dl[i].t;
  }
}

}  // namespace wuerfel
