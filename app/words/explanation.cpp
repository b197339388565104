#include "app/words/explanation.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/words/naming.h"

namespace wuerfel {

namespace {

/// Causes and moving parts that are told; the rest follows from them.
constexpr std::size_t most_told = 4;
/// A margin that is none, as a share of the smaller side.
constexpr double knife_edge = 1e-9;

/// Whether the part is told as several cubes; of many one stands for all.
bool is_many(const std::vector<int>& cubes) {
  return cubes.size() > 1 && cubes.size() <= most_names;
}

/// How many of so many are told: of one more than most there is no "1 more".
std::size_t told_of(std::size_t count) {
  return count == most_told + 1 ? count : std::min(count, most_told);
}

std::string tip_sentence(const StillScene& still,
                         const Cause& cause,
                         const std::string& part,
                         Language language) {
  const Contact& c = still.found.islands[cause.island].island.contacts[*cause.part.pivot];
  const bool own = std::ranges::binary_search(cause.part.cubes, c.on);
  const bool many = is_many(cause.part.cubes);
  const Phrase corner = !own ? Phrase::corner_of : many ? Phrase::own_corners : Phrase::own_corner;
  const std::string on = list_in(language, names_of(still, cause.on));
  return say_in(language, many ? Phrase::tip : Phrase::tips,
                {{"part", part},
                 {"side", side_name(cause.sense, language)},
                 {"corner", say_in(language, corner, {{"on", on}})},
                 {"length", length_in(language, *cause.outside)}});
}

/// The phrase of a part that does not tip, of one cube and of several.
std::pair<Phrase, Phrase> loss_phrases(const StillScene& still, const Cause& cause) {
  if (cause.failure == FailureMode::drops) return {Phrase::drops, Phrase::drop};
  if (cause.failure == FailureMode::swings) return {Phrase::swings, Phrase::swing};
  const auto rubs = [&](int k) {
    const Contact& c = still.found.islands[cause.island].island.contacts[k];
    return still.system.surface(c.on, c.from).friction > 0.0;
  };
  if (std::ranges::any_of(cause.part.presses, rubs)) {
    if (cause.sense == 0) return {Phrase::rubs_down, Phrase::rub_down};
    return {Phrase::rubs_away, Phrase::rub_away};
  }
  if (cause.sense == 0) return {Phrase::gives_way, Phrase::give_way};
  return {Phrase::slides, Phrase::slide};
}

std::string moving_part_sentence(const StillScene& still,
                                 const MovingPart& part,
                                 Language language) {
  const bool many = is_many(part.cubes);
  std::string partners;
  if (!part.opens.empty()) {
    partners = say_in(language, many ? Phrase::part_from : Phrase::parts_from,
                      {{"names", list_in(language, names_of(still, part.opens))}});
  }
  // What does nothing of the work worth telling is only carried along.
  constexpr double share_told = 0.005;
  std::string work;
  if (std::abs(part.work_share) >= share_told) {
    const Phrase takes = many ? Phrase::take_work : Phrase::takes_work;
    const Phrase gives = many ? Phrase::give_work : Phrase::gives_work;
    work = say_in(language, part.work_share < 0.0 ? takes : gives,
                  {{"share", percent_in(language, std::abs(part.work_share))}});
  }
  const Phrase turns = many ? Phrase::turn : Phrase::turns;
  const Phrase goes = many ? Phrase::go : Phrase::goes;
  return say_in(language, part.turn != 0 ? turns : goes,
                {{"part", part_name(still, part.cubes, part.cubes.front(), language)},
                 {"side", say_in(language, part.turn > 0 ? Phrase::left : Phrase::right)},
                 {"way", say_in(language, direction_of(still, part.motion.linear))},
                 {"partners", partners},
                 {"work", work}});
}

/// What nothing carries, in one sentence.
std::string drop_sentence(const StillScene& still, const Causes& causes, Language language) {
  std::vector<int> cubes;
  for (const Cause& cause : causes.causes) {
    if (cause.failure == FailureMode::drops)
      cubes.insert(cubes.end(), cause.part.cubes.begin(), cause.part.cubes.end());
  }
  std::vector<std::string> names = names_of(still, cubes);
  if (names.size() > most_told) {
    const std::string count = std::to_string(names.size() - most_names);
    names.resize(most_names);
    names.push_back(say_in(language, Phrase::more, {{"count", count}}));
  }
  return say_in(language, names.size() == 1 ? Phrase::drops : Phrase::drop,
                {{"part", list_in(language, names)}});
}

void tell_causes(const StillScene& still,
                 const Causes& causes,
                 Language language,
                 std::vector<std::string>& text) {
  const auto drops = [](const Cause& cause) { return cause.failure == FailureMode::drops; };
  const std::size_t others = causes.causes.size() - std::ranges::count_if(causes.causes, drops);
  const std::size_t most = told_of(others);
  std::size_t told = 0;
  bool dropped = false;
  for (const Cause& cause : causes.causes) {
    if (drops(cause)) {
      if (!dropped) text.push_back(drop_sentence(still, causes, language));
      dropped = true;
    } else if (told < most) {
      text.push_back(cause_sentence(still, cause, language));
      ++told;
    }
  }
  if (told < others) {
    text.push_back(
        say_in(language, Phrase::more_causes, {{"count", std::to_string(others - told)}}));
  }
}

void tell_fall(const Explanation& e, Language language, std::vector<std::string>& text) {
  const StillScene& still = *e.still;
  tell_causes(still, e.causes, language, text);
  std::ranges::move(mechanism_sentences(e, language), std::back_inserter(text));
  for (const Fix& fix : e.fixes)
    text.push_back(fix_sentence(still, fix, language));
  const bool only_drops = std::ranges::all_of(
      e.causes.causes, [](const Cause& c) { return c.failure == FailureMode::drops; });
  if (e.fixes.empty() && !(only_drops && e.causes.mechanism.empty()))
    text.push_back(say_in(language, Phrase::nothing_found));
  text.push_back(
      say_in(language, Phrase::proof, {{"power", power_in(language, e.causes.certificate.power)}}));
}

void tell_margin(const Explanation& e, Language language, std::vector<std::string>& text) {
  if (!e.weakest) {
    text.push_back(say_in(language, Phrase::no_weakest));
    return;
  }
  constexpr double as_far = 1.0 + 1e-9;
  const bool right = e.weakest->shift.high <= -e.weakest->shift.low * as_far;
  const double most = std::min(e.weakest->shift.high, -e.weakest->shift.low);
  // What hangs on rods swings: it need not be on the edge of falling.
  const Phrase none = e.still->system.rods.empty() ? Phrase::knife_edge : Phrase::no_shift;
  text.push_back(say_in(language, e.weakest->share <= knife_edge ? none : Phrase::weakest,
                        {{"body", e.still->system.body(e.weakest->cube).name},
                         {"side", side_name(right ? 1 : -1, language)},
                         {"length", length_in(language, most)}}));
}

void tell_tilt(const std::optional<TiltMargin>& tilt,
               Phrase phrase,
               Language language,
               std::vector<std::string>& text) {
  if (!tilt) return;
  text.push_back(say_in(language, phrase,
                        {{"to_left", angle_in(language, tilt->left)},
                         {"to_right", angle_in(language, tilt->right)}}));
}

void tell_stand(const Explanation& e, Language language, std::vector<std::string>& text) {
  const bool needs_friction = e.check.facts && !e.check.facts->stands_without_friction;
  text.push_back(say_in(language, needs_friction ? Phrase::equilibrium : Phrase::stands));
  if (e.check.facts && e.check.facts->fall_also_possible)
    text.push_back(say_in(language, Phrase::fall_also_possible));
  tell_margin(e, language, text);
  tell_tilt(e.tilt_given, Phrase::tilt_given, language, text);
  tell_tilt(e.tilt, Phrase::tilt, language, text);
}

std::optional<TiltMargin> largest_tilt(const StillScene& still, Sliding sliding) {
  const LoadRange range = tilt_range(still, sliding);
  return is_empty(range) ? std::nullopt : std::optional(tilt_angles(range));
}

void tell_motion(const std::vector<std::string>& names,
                 Language language,
                 std::vector<std::string>& text) {
  text.push_back(say_in(language, names.size() == 1 ? Phrase::moves : Phrase::move,
                        {{"names", list_in(language, names)}}));
}

}  // namespace

std::vector<std::string> moving_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneCube& cube : scene.cubes)
    if (!cube.velocity.isZero(0.0) || cube.spin != 0.0) names.push_back(cube.name);
  for (const ScenePoint& point : scene.points)
    if (!point.velocity.isZero(0.0)) names.push_back(point.name);
  return names;
}

std::vector<std::string> mechanism_sentences(const Explanation& e, Language language) {
  std::vector<std::string> text;
  const std::vector<MovingPart>& parts = e.causes.mechanism;
  if (!parts.empty()) text.push_back(say_in(language, Phrase::no_part_alone));
  const std::size_t told = told_of(parts.size());
  for (std::size_t k = 0; k < told; ++k)
    text.push_back(moving_part_sentence(*e.still, parts[k], language));
  if (told < parts.size()) {
    text.push_back(
        say_in(language, Phrase::more_move, {{"count", std::to_string(parts.size() - told)}}));
  }
  return text;
}

std::string cause_sentence(const StillScene& still, const Cause& cause, Language language) {
  const std::string part = part_name(still, cause.part.cubes, cause.base, language);
  if (cause.failure == FailureMode::tips) return tip_sentence(still, cause, part, language);
  const auto [one, many] = loss_phrases(still, cause);
  return say_in(language, is_many(cause.part.cubes) ? many : one,
                {{"part", part},
                 {"side", side_name(cause.sense, language)},
                 {"way", way_name(cause.sense, language)},
                 {"on", list_in(language, names_of(still, cause.on))}});
}

std::string fix_sentence(const StillScene& still, const Fix& fix, Language language) {
  const std::string& body = still.system.body(fix.cube).name;
  if (fix.kind == Fix::Kind::move) {
    const bool carries = fix.carried > 1;
    return say_in(language, Phrase::fix_move,
                  {{"body", body},
                   {"load", carries ? say_in(language, Phrase::with_load) : ""},
                   {"length", length_in(language, std::abs(fix.distance), Rounding::up)},
                   {"side", side_name(fix.distance < 0.0 ? -1 : 1, language)}});
  }
  return say_in(language, Phrase::fix_force,
                {{"corner", say_in(language, corner_of(still, fix.cube, fix.point))},
                 {"body", body},
                 {"way", say_in(language, direction_of(still, fix.force))},
                 {"force", force_in(language, fix.force.norm(), Rounding::up)}});
}

Explanation explain(const Scene& scene, const MotionSettings& settings) {
  Explanation e;
  e.check = check(scene, settings);
  if (e.check.verdict == Verdict::moves) return e;
  e.still = stopped_scene(scene, settings);
  if (e.check.verdict != Verdict::stands) {
    e.causes = find_causes(*e.still);
    e.fixes = find_fixes(*e.still, settings, e.causes);
    return e;
  }
  e.weakest = find_weakest(*e.still);
  if (e.still->system.rubs) e.tilt_given = largest_tilt(*e.still, Sliding::given);
  e.tilt = largest_tilt(*e.still, Sliding::none);
  return e;
}

std::vector<std::string> sentences(const Scene& scene, const Explanation& e, Language language) {
  std::vector<std::string> text;
  switch (e.check.verdict) {
    case Verdict::stands:
      tell_stand(e, language, text);
      break;
    case Verdict::falls:
      tell_fall(e, language, text);
      break;
    case Verdict::moves:
      tell_motion(moving_names(scene), language, text);
      break;
    case Verdict::undecided:
      text.push_back(say_in(language, Phrase::undecided));
      break;
  }
  return text;
}

}  // namespace wuerfel
