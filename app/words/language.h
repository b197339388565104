/// Sentences for people, in their language: one table of templates.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wuerfel {

enum class Language { en, de };
std::string_view to_string(Language language);

/// What there is to say.
enum class Phrase {
  stands,
  equilibrium,
  fall_also_possible,
  undecided,
  moves,
  move,
  weakest,
  knife_edge,
  no_shift,
  no_weakest,
  tilt_given,
  tilt,
  any_tilt,
  tips,
  tip,
  corner_of,
  own_corner,
  own_corners,
  slides,
  slide,
  rubs_away,
  rub_away,
  rubs_down,
  rub_down,
  gives_way,
  give_way,
  swings,
  swing,
  drops,
  drop,
  more,
  more_causes,
  no_part_alone,
  turns,
  turn,
  goes,
  go,
  gives_work,
  give_work,
  takes_work,
  take_work,
  parts_from,
  part_from,
  more_move,
  proof,
  fix_move,
  fix_force,
  with_load,
  with_many,
  left,
  right,
  to_the_left,
  to_the_right,
  upwards,
  downwards,
  upper_left,
  upper_right,
  lower_left,
  lower_right,
  and_word,
  nothing_found,
};

/// Values of the names in braces.
using Values = std::vector<std::pair<std::string, std::string>>;

std::string say_in(Language language, Phrase phrase, const Values& values = {});

/// "a", "a and b", "a, b and c".
std::string list_in(Language language, const std::vector<std::string>& names);

enum class Rounding { nearest, up };

/// Three digits and the unit that fits: "0.5 mm", "50 mm", "1.25 m".
std::string length_in(Language language, double metres, Rounding rounding = Rounding::nearest);
std::string force_in(Language language, double newtons, Rounding rounding = Rounding::nearest);
std::string power_in(Language language, double watts);
/// Of radians: "11.3°".
std::string angle_in(Language language, double radians);
std::string percent_in(Language language, double share);

}  // namespace wuerfel
