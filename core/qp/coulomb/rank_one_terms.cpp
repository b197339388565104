#include "core/qp/coulomb/rank_one_terms.h"

#include "core/qp/block/quad_vector.h"

namespace wuerfel {
namespace {

constexpr Eigen::Index most_terms = 40;  ///< beyond them K is factorised anew at the same cost

}  // namespace

bool RankOneTerms::add(const ContactForm& form, int unit, const Pair& a, const Pair& b) {
  const auto last = static_cast<Eigen::Index>(terms_.size());
  if (last == most_terms) return false;
  terms_.push_back({unit, b, std::vector<Quad>(form.blocks(), Quad{})});
  Term& added = terms_.back();
  form.add_transposed(unit, a, added.column.data());
  form.solve(added.column.data());
  small_.conservativeResize(last + 1, last + 1);
  for (Eigen::Index k = 0; k <= last; ++k) {
    const Term& term = terms_[static_cast<std::size_t>(k)];
    small_(last, k) = share(added, form.rows(unit, term.column.data()));
    small_(k, last) = share(term, form.rows(term.unit, added.column.data()));
  }
  small_(last, last) += 1.0;
  factors_.compute(small_);
  return small_.col(last).allFinite() && small_.row(last).allFinite();
}

void RankOneTerms::solve(const ContactForm& form, std::vector<Quad>& v) const {
  form.solve(v.data());
  if (!terms_.empty()) subtract_terms(form, v);
}

void RankOneTerms::correct(const ContactForm& form,
                           const Pair& missing,
                           std::vector<Quad>& v) const {
  std::vector<Quad> column = terms_.back().column;
  subtract_terms(form, column);
  wuerfel::add(share(terms_.back(), missing), column, v);
}

/// From K^-1 v to (K + terms)^-1 v.
void RankOneTerms::subtract_terms(const ContactForm& form, std::vector<Quad>& v) const {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(terms_.size()));
  Eigen::Index k = 0;
  for (const Term& term : terms_)
    shares[k++] = share(term, form.rows(term.unit, v.data()));
  shares = factors_.solve(shares);
  k = 0;
  for (const Term& term : terms_)
    wuerfel::add(-shares[k++], term.column, v);
}

}  // namespace wuerfel
