#include "app/sweep/statics.h"

namespace wuerfel {

const Check& Statics::check() {
  if (!check_) check_ = wuerfel::check(scene_, {});
  return *check_;
}

const std::optional<StillScene>& Statics::still() {
  if (!still_) {
    still_.emplace();
    const Verdict verdict = check().verdict;
    if (verdict == Verdict::stands || verdict == Verdict::falls)
      still_->emplace(stopped_scene(scene_, {}));
  }
  return *still_;
}

const std::optional<Nearest>& Statics::nearest() {
  if (nearest_) return *nearest_;
  nearest_.emplace();
  if (!still()) return *nearest_;
  if (check().verdict == Verdict::stands) {
    if (const std::optional<Weakest> weakest = find_weakest(*still()))
      nearest_->emplace(Nearest{weakest->share, weakest->cube});
  } else {
    const Margins margins = find_margins(*still(), {}, {false, false, true, false, {}});
    if (margins.smallest) nearest_->emplace(Nearest{*margins.smallest, margins.weakest});
  }
  return *nearest_;
}

const std::optional<Cause>& Statics::cause() {
  if (!cause_) {
    cause_.emplace();
    if (still() && check().verdict == Verdict::falls) *cause_ = first_cause(*still());
  }
  return *cause_;
}

std::vector<std::uint16_t> Statics::violations() {
  std::vector<std::uint16_t> numbers(scene_.cubes.size(), 0);
  if (!cause()) return numbers;
  for (const int body : cause()->on)
    if (still()->system.is_cube(body)) numbers[body] = 2;
  for (const int body : cause()->part.cubes)
    if (still()->system.is_cube(body)) numbers[body] = 1;
  return numbers;
}

std::string Statics::cause_text() {
  std::string text;
  for (const int body : cause()->part.cubes)
    text += (text.empty() ? "" : "+") + moving_name(scene_, body);
  return text;
}

Label Statics::label(CheckColumn column) {
  switch (column) {
    case CheckColumn::verdict:
      return std::string(to_string(check().verdict));
    case CheckColumn::contacts:
      return static_cast<std::int64_t>(check().contacts.size());
    case CheckColumn::margin:
      return nearest() ? Label(nearest()->margin) : Label();
    case CheckColumn::weakest:
      return nearest() ? Label(moving_name(scene_, nearest()->cube)) : Label();
    case CheckColumn::causes:
      return cause() ? Label(cause_text()) : Label();
  }
  return {};
}

LabelRow Statics::labels(const std::vector<CheckColumn>& columns) {
  LabelRow row;
  for (const CheckColumn column : columns)
    row.emplace_back(to_string(column), label(column));
  return row;
}

}  // namespace wuerfel
