#include "app/words/language.h"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace wuerfel {

namespace {

struct Template {
  Phrase phrase;
  const char* en;
  const char* de;
};

// Names of bodies stand without an article, so that any name fits.
constexpr std::array templates{
    Template{Phrase::stands, "It stands.", "Es steht."},
    Template{Phrase::equilibrium, "It can stand: friction allows forces that hold all weights.",
             "Es kann stehen: Die Reibung lässt Kräfte zu, die alle Gewichte halten."},
    Template{Phrase::fall_also_possible, "A fall satisfies the law of friction as well.",
             "Auch ein Fall erfüllt das Reibungsgesetz."},
    Template{Phrase::undecided, "Whether it stands cannot be told within rounding.",
             "Ob es steht, lässt sich im Rahmen der Rundung nicht sagen."},
    Template{Phrase::moves, "{names} is moving from the start.",
             "{names} ist von Anfang an in Bewegung."},
    Template{Phrase::move, "{names} are moving from the start.",
             "{names} sind von Anfang an in Bewegung."},
    Template{Phrase::weakest,
             "The weakest is {body}: its weight may shift {length} to the {side}, no more.",
             "Am schwächsten ist {body}: Das Gewicht darf um {length} nach {side} rücken, nicht "
             "weiter."},
    Template{Phrase::knife_edge,
             "It stands on a knife edge: {body} may not move to the {side} at all.",
             "Es steht auf der Kippe: {body} darf nicht weiter nach {side}."},
    Template{Phrase::no_shift, "Any shift of the weight of {body} sets it in motion.",
             "Jedes Verschieben des Gewichts von {body} setzt es in Bewegung."},
    Template{Phrase::no_weakest, "No shift of a weight makes it fall.",
             "Kein Verschieben eines Gewichts bringt es zu Fall."},
    Template{
        Phrase::tilt_given,
        "Forces that hold it exist up to a tilt of {to_left} to the left and {to_right} to the "
        "right.",
        "Kräfte, die es halten, gibt es bis zu einer Neigung von {to_left} nach links und "
        "{to_right} nach rechts."},
    Template{Phrase::tilt,
             "If nothing could slide, it would stand up to a tilt of {to_left} to the left and "
             "{to_right} to the right.",
             "Könnte nichts rutschen, stünde es bis zu einer Neigung von {to_left} nach links und "
             "{to_right} nach rechts."},
    Template{Phrase::any_tilt, "any angle", "jedem Winkel"},
    Template{Phrase::tips,
             "{part} tips to the {side} over {corner}: its centre of mass is {length} outside.",
             "{part} kippt nach {side} über {corner}: Der Schwerpunkt liegt {length} außerhalb."},
    Template{Phrase::tip,
             "{part} together tip to the {side} over {corner}: their centre of mass is {length} "
             "outside.",
             "{part} kippen zusammen nach {side} über {corner}: Ihr Schwerpunkt liegt {length} "
             "außerhalb."},
    Template{Phrase::corner_of, "the corner of {on}", "die Ecke von {on}"},
    Template{Phrase::own_corner, "its own corner on {on}", "die eigene Ecke auf {on}"},
    Template{Phrase::own_corners, "their own corner on {on}", "die eigene Ecke auf {on}"},
    Template{Phrase::slides, "{part} slides to the {side} on {on}: nothing holds it there.",
             "{part} rutscht nach {side}: Auf {on} hält nichts."},
    Template{Phrase::slide,
             "{part} together slide to the {side} on {on}: nothing holds them there.",
             "{part} rutschen zusammen nach {side}: Auf {on} hält nichts."},
    Template{Phrase::rubs_away,
             "{part} moves to the {side} on {on}: there is not enough friction to hold it.",
             "{part} bewegt sich auf {on} nach {side}: Die Reibung reicht nicht."},
    Template{
        Phrase::rub_away,
        "{part} together move to the {side} on {on}: there is not enough friction to hold them.",
        "{part} bewegen sich zusammen auf {on} nach {side}: Die Reibung reicht nicht."},
    Template{Phrase::rubs_down,
             "{part} slides down on {on}: there is not enough friction to hold it.",
             "{part} rutscht an {on} hinab: Die Reibung reicht nicht."},
    Template{Phrase::rub_down,
             "{part} together slide down on {on}: there is not enough friction to hold them.",
             "{part} rutschen zusammen an {on} hinab: Die Reibung reicht nicht."},
    Template{Phrase::gives_way, "{part} gives way on {on}.", "{part} gibt auf {on} nach."},
    Template{Phrase::give_way, "{part} together give way on {on}.",
             "{part} geben zusammen auf {on} nach."},
    Template{Phrase::swings, "{part} swings {way}: its rods do not hold it there.",
             "{part} schwingt {way}: Die Stangen halten es dort nicht."},
    Template{Phrase::swing, "{part} together swing {way}: their rods do not hold them there.",
             "{part} schwingen zusammen {way}: Die Stangen halten sie dort nicht."},
    Template{Phrase::drops, "{part} falls: nothing carries it.", "{part} fällt: Nichts trägt es."},
    Template{Phrase::drop, "{part} fall: nothing carries them.",
             "{part} fallen: Nichts trägt sie."},
    Template{Phrase::more, "{count} more", "{count} weitere"},
    Template{Phrase::more_causes, "{count} more parts fail by themselves.",
             "{count} weitere Teile fallen für sich."},
    Template{Phrase::no_part_alone, "No part fails by itself; together they give way:",
             "Kein Teil fällt für sich; zusammen geben sie nach:"},
    Template{Phrase::turns, "{part} turns to the {side}{partners}{work}.",
             "{part} dreht sich nach {side}{partners}{work}."},
    Template{Phrase::turn, "{part} turn to the {side}{partners}{work}.",
             "{part} drehen sich nach {side}{partners}{work}."},
    Template{Phrase::goes, "{part} goes {way}{partners}{work}.",
             "{part} geht {way}{partners}{work}."},
    Template{Phrase::go, "{part} go {way}{partners}{work}.", "{part} gehen {way}{partners}{work}."},
    Template{Phrase::gives_work, "; its weight does {share} of the work",
             "; das Gewicht leistet {share} der Arbeit"},
    Template{Phrase::give_work, "; their weight does {share} of the work",
             "; ihr Gewicht leistet {share} der Arbeit"},
    Template{Phrase::takes_work, "; its weight is lifted, which takes {share} of the work",
             "; das Gewicht wird gehoben, was {share} der Arbeit braucht"},
    Template{Phrase::take_work, "; their weight is lifted, which takes {share} of the work",
             "; ihr Gewicht wird gehoben, was {share} der Arbeit braucht"},
    Template{Phrase::parts_from, ", parts from {names}", ", löst sich von {names}"},
    Template{Phrase::part_from, ", part from {names}", ", lösen sich von {names}"},
    Template{Phrase::more_move, "{count} more parts move with them.",
             "{count} weitere Teile bewegen sich mit."},
    Template{
        Phrase::proof,
        "Proof: there is a motion in which no contact closes and the weights do work, {power} "
        "after a second.",
        "Beweis: Es gibt eine Bewegung, bei der sich keine Berührung schließt und die Gewichte "
        "Arbeit leisten, {power} nach einer Sekunde."},
    Template{Phrase::fix_move, "It stands if {body}{load} is moved {length} to the {side}.",
             "Es steht, wenn man {body}{load} um {length} nach {side} schiebt."},
    Template{Phrase::fix_force,
             "It stands if a force of {force} {way} acts at the {corner} corner of {body}.",
             "Es steht, wenn an der Ecke {corner} von {body} eine Kraft von {force} {way} wirkt."},
    Template{Phrase::with_load, ", with what it carries,", " mit allem darauf"},
    Template{Phrase::with_many, "{body} with the {count} cubes on it",
             "{body} mit den {count} Würfeln darauf"},
    Template{Phrase::left, "left", "links"},
    Template{Phrase::right, "right", "rechts"},
    Template{Phrase::to_the_left, "to the left", "nach links"},
    Template{Phrase::to_the_right, "to the right", "nach rechts"},
    Template{Phrase::upwards, "upwards", "nach oben"},
    Template{Phrase::downwards, "downwards", "nach unten"},
    Template{Phrase::upper_left, "upper left", "oben links"},
    Template{Phrase::upper_right, "upper right", "oben rechts"},
    Template{Phrase::lower_left, "lower left", "unten links"},
    Template{Phrase::lower_right, "lower right", "unten rechts"},
    Template{Phrase::and_word, "and", "und"},
    Template{Phrase::nothing_found,
             "No single move and no single force was found that makes it stand.",
             "Es fand sich kein Schieben eines Würfels und keine einzelne Kraft, womit es steht."},
};

constexpr int digits = 3;

// Three digits, rounded so that the advice still holds; what is above by rounding only is not.
double rounded(double value, Rounding rounding) {
  if (value == 0.0 || rounding == Rounding::nearest) return value;
  constexpr double noise = 1e-6;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1);
  return std::ceil(std::abs(value) / unit - noise) * unit;
}

std::string number_in(Language language, double value) {
  std::string text = fmt::format("{:.3g}", value);
  if (text.find('e') != std::string::npos) text = fmt::format("{:.0f}", value);
  if (language == Language::de) {
    const std::size_t point = text.find('.');
    if (point != std::string::npos) text[point] = ',';
  }
  return text;
}

struct Unit {
  double size;
  const char* name;
};

// In the largest unit that it is not small in.
template <std::size_t count>
std::string in_units(Language language, double value, const std::array<Unit, count>& units) {
  const Unit* unit = units.data();
  while (unit + 1 != units.data() + count && std::abs(value) < 0.0999 * unit->size)
    ++unit;
  return number_in(language, value / unit->size) + " " + unit->name;
}

}  // namespace

std::string_view to_string(Language language) {
  switch (language) {
    case Language::en:
      return "en";
    case Language::de:
      return "de";
  }
  return "?";
}

std::string say_in(Language language, Phrase phrase, const Values& values) {
  std::string text;
  for (const Template& t : templates)
    if (t.phrase == phrase) text = language == Language::de ? t.de : t.en;
  for (const auto& [name, value] : values) {
    const std::string brace = "{" + name + "}";
    for (std::size_t at = text.find(brace); at != std::string::npos;
         at = text.find(brace, at + value.size()))
      text.replace(at, brace.size(), value);
  }
  return text;
}

std::string list_in(Language language, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0)
      text += i + 1 == names.size() ? " " + say_in(language, Phrase::and_word) + " " : ", ";
    text += names[i];
  }
  return text;
}

std::string length_in(Language language, double metres, Rounding rounding) {
  constexpr std::array units{Unit{1.0, "m"}, Unit{1e-3, "mm"}, Unit{1e-6, "µm"}, Unit{1e-9, "nm"}};
  // Millimetres up to a metre, as on a drawing.
  const double value = rounded(metres, rounding);
  if (std::abs(value) >= 1e-4 && std::abs(value) < 0.9995)
    return number_in(language, value / units[1].size) + " mm";
  return in_units(language, value, units);
}

std::string force_in(Language language, double newtons, Rounding rounding) {
  constexpr std::array units{Unit{1.0, "N"}, Unit{1e-3, "mN"}, Unit{1e-6, "µN"}, Unit{1e-9, "nN"}};
  const double value = rounded(newtons, rounding);
  if (std::abs(value) >= 1e3) return number_in(language, value / 1e3) + " kN";
  return in_units(language, value, units);
}

std::string power_in(Language language, double watts) {
  constexpr std::array units{Unit{1.0, "W"}, Unit{1e-3, "mW"}, Unit{1e-6, "µW"}, Unit{1e-9, "nW"}};
  return in_units(language, watts, units);
}

std::string angle_in(Language language, double radians) {
  if (!std::isfinite(radians)) return say_in(language, Phrase::any_tilt);
  return number_in(language, radians * 180.0 / std::numbers::pi + 0.0) + "°";
}

std::string percent_in(Language language, double share) {
  return number_in(language, std::round(100.0 * share) + 0.0) + " %";
}

}  // namespace wuerfel
