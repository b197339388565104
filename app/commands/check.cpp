#include "core/check.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/option_groups.h"
#include "app/commands/batch.h"
#include "app/commands/check_json.h"
#include "app/commands/commands.h"
#include "app/commands/idle_options.h"
#include "app/commands/statics_options.h"
#include "app/output/table_text.h"
#include "app/words/explanation.h"
#include "core/model/scales.h"
#include "core/work_in_order.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

struct CheckOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> overrides;
  MotionSettings motion;
  StaticsRequest statics;
  bool json = false;
  int threads = 0;
};

// Keys "rods" and "pins", always there: a scene without them has none.
void add_rods(const Check& answer, Json& json) {
  Json rods = Json::array();
  for (const RodForce& rod : answer.rods)
    rods.push_back({{"name", rod.name}, {"force", rod.force}, {"unique", rod.unique}});
  Json pins = Json::array();
  for (const PinForce& pin : answer.pins) {
    pins.push_back(
        {{"name", pin.name}, {"force", {pin.force.x(), pin.force.y()}}, {"unique", pin.unique}});
  }
  json["rods"] = std::move(rods);
  json["pins"] = std::move(pins);
}

}  // namespace

ExitCode exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::stands:
      return ExitCode::fine;
    case Verdict::falls:
    case Verdict::moves:
      return ExitCode::negative;
    case Verdict::undecided:
      return ExitCode::undecided;
  }
  return ExitCode::internal;
}

nlohmann::ordered_json check_json(const Scene& scene, const Check& answer) {
  // Keys are appended: looking for each among those before takes longer than all else in large scenes.
  Json::object_t accelerations;
  accelerations.reserve(answer.accelerations.size());
  for (std::size_t i = 0; i < answer.accelerations.size(); ++i) {
    const Twist& a = answer.accelerations[i];
    Json of_body{{"ax", a.linear.x()}, {"ay", a.linear.y()}};
    if (i < scene.cubes.size()) of_body["alpha"] = a.angular;
    accelerations.emplace_back(moving_name(scene, static_cast<int>(i)), std::move(of_body));
  }
  Json::array_t contacts;
  contacts.reserve(answer.contacts.size());
  for (const ContactForce& contact : answer.contacts) {
    Json::object_t of_contact;
    of_contact.reserve(7);
    of_contact.emplace_back("on", contact.on);
    of_contact.emplace_back("from", contact.from);
    of_contact.emplace_back("point", Json::array_t{contact.point.x(), contact.point.y()});
    // Adding 0 turns -0 into 0.
    of_contact.emplace_back("normal",
                            Json::array_t{contact.normal.x() + 0.0, contact.normal.y() + 0.0});
    of_contact.emplace_back("force", contact.force);
    of_contact.emplace_back("tangential", contact.tangential);
    of_contact.emplace_back("unique", contact.unique);
    contacts.emplace_back(std::move(of_contact));
  }
  Json json{{"verdict", to_string(answer.verdict)},
            {"accelerations", std::move(accelerations)},
            {"contacts", std::move(contacts)}};
  add_rods(answer, json);
  if (answer.facts) {
    json["facts"] = {{"equilibrium_exists", answer.facts->equilibrium_exists},
                     {"stands_without_friction", answer.facts->stands_without_friction},
                     {"fall_also_possible", answer.facts->fall_also_possible}};
  }
  // There are no accelerations, then: those told are the nearest that were found.
  if (answer.jams) json["painleve"] = true;
  json["objective"] = answer.objective;
  json["kkt_residual"] = answer.kkt_residual;
  return json;
}

namespace {

// Turning as far as it moves the body's sides: what is far below the rest is rounding.
std::string acceleration_text(const Body& body, const Twist& a) {
  const double all = size_of(body, a);
  const double side = size_of(body, {Vec2::Zero(), 1.0});
  return fmt::format("({:.6g}, {:.6g}) m/s^2 and {:.6g} rad/s^2", rounded(a.linear.x(), all),
                     rounded(a.linear.y(), all),
                     rounded(a.angular * side, all) == 0.0 ? 0.0 : a.angular);
}

// The virtual motion that proves that there is no equilibrium, of the cubes that take part.
std::string certificate_text(const Scene& scene, const Check& answer) {
  std::string text =
      "no equilibrium exists: no force that Coulomb's law allows holds the weight along the "
      "virtual "
      "motion\n";
  const System system = make_system(scene);
  double largest = 0.0;
  for (std::size_t i = 0; i < answer.certificate.size(); ++i)
    largest = std::max(largest, size_of(system.bodies[i], answer.certificate[i]));
  for (std::size_t i = 0; i < answer.certificate.size(); ++i) {
    const Twist& a = answer.certificate[i];
    if (rounded(size_of(system.bodies[i], a), largest) == 0.0) continue;
    text += fmt::format("  {}: {}\n", moving_name(scene, static_cast<int>(i)),
                        acceleration_text(system.bodies[i], a));
  }
  return text;
}

std::string friction_text(const Scene& scene, const Check& answer) {
  std::string text;
  if (answer.facts && answer.facts->equilibrium_exists) {
    text += "an equilibrium exists";
    if (answer.facts->fall_also_possible) text += "; a fall satisfies the law as well";
    text += answer.facts->stands_without_friction ? "; it needs no friction\n" : "\n";
  }
  if (!answer.certificate.empty()) text += certificate_text(scene, answer);
  if (answer.jams)
    text += "no acceleration satisfies Coulomb's law (Painlevé): what slips jams at once\n";
  return text;
}

// Who accelerates most, measured as the verdict is: |a| + side |alpha|.
std::string fastest_text(const Scene& scene, const Check& answer) {
  const System system = make_system(scene);
  const auto severity = [&](std::size_t i) {
    return size_of(system.bodies[i], answer.accelerations[i]);
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < answer.accelerations.size(); ++i) {
    if (severity(i) > severity(worst)) worst = i;
  }
  return fmt::format("largest acceleration: {} with {}\n",
                     moving_name(scene, static_cast<int>(worst)),
                     acceleration_text(system.bodies[worst], answer.accelerations[worst]));
}

// The first part that fails, if any does alone.
std::string cause_text(const Scene& scene, const MotionSettings& motion) {
  const StillScene still = stopped_scene(scene, motion);
  const std::optional<Cause> cause = first_cause(still);
  return cause ? cause_sentence(still, *cause, Language::en) + "\n" : "";
}

std::string contacts_text(const Scene& scene, const Check& answer) {
  if (answer.contacts.empty()) return "";
  NameColumn on;
  NameColumn from;
  double farthest = 0.0;
  double largest = 0.0;
  for (const SceneCube& cube : scene.cubes)
    farthest = std::max(farthest, cube.size.maxCoeff());
  for (const ContactForce& contact : answer.contacts) {
    on.include(contact.on);
    from.include(contact.from);
    farthest = std::max(farthest, contact.point.cwiseAbs().maxCoeff());
    largest = std::max(largest, contact.force);
  }
  std::string text = fmt::format("\n{:<{}} {:<{}} {:>10} {:>10} {:>12} {:>12}\n", "on", on.width(),
                                 "from", from.width(), "x / m", "y / m", "force / N", "along / N");
  for (const ContactForce& contact : answer.contacts) {
    text += fmt::format("{:<{}} {:<{}} {:>10.4g} {:>10.4g} {:>12.6g} {:>12.6g}{}\n", contact.on,
                        on.width(), contact.from, from.width(),
                        rounded(contact.point.x(), farthest), rounded(contact.point.y(), farthest),
                        rounded(contact.force, largest), rounded(contact.tangential, largest),
                        contact.unique ? "" : "  not the only one possible");
  }
  return text;
}

// For people: the verdict, why, who accelerates most, and what presses where.
std::string check_text(const Scene& scene, const MotionSettings& motion, const Check& answer) {
  std::string text = fmt::format("{}\n", to_string(answer.verdict));
  if (answer.verdict == Verdict::falls) text += cause_text(scene, motion);
  if (answer.verdict == Verdict::falls || answer.verdict == Verdict::undecided)
    text += fastest_text(scene, answer);
  if (answer.verdict == Verdict::moves)
    text += fmt::format("moving at the start: {}\n", fmt::join(moving_names(scene), ", "));
  text += friction_text(scene, answer);
  return text + contacts_text(scene, answer);
}

// Forces of rods and pins.
std::string joints_text(const Check& answer) {
  std::string text;
  NameColumn names;
  double largest = 0.0;
  for (const RodForce& rod : answer.rods) {
    names.include(rod.name);
    largest = std::max(largest, std::abs(rod.force));
  }
  for (const PinForce& pin : answer.pins) {
    names.include(pin.name);
    largest = std::max(largest, pin.force.norm());
  }
  const auto add = [&](const std::string& name, const std::string& what, bool unique) {
    text += fmt::format("{:<{}} {}{}\n", name, names.width(), what,
                        unique ? "" : "  not the only one possible");
  };
  if (!answer.rods.empty())
    text += fmt::format("\n{:<{}} {:>12}\n", "rod", names.width(), "force / N");
  for (const RodForce& rod : answer.rods) {
    const char* way = rod.force < 0.0 ? "pushes" : "pulls";
    add(rod.name, fmt::format("{:>12.6g} {:<6}", rounded(rod.force, largest), way), rod.unique);
  }
  if (!answer.pins.empty())
    text += fmt::format("\n{:<{}} {:>12} {:>12}\n", "pin", names.width(), "fx / N", "fy / N");
  for (const PinForce& pin : answer.pins) {
    add(pin.name,
        fmt::format("{:>12.6g} {:>12.6g}", rounded(pin.force.x(), largest),
                    rounded(pin.force.y(), largest)),
        pin.unique);
  }
  return text;
}

std::string answer_text(const std::string& name,
                        const Scene& scene,
                        const MotionSettings& motion,
                        const Check& answer,
                        const StaticsAnswer& statics,
                        AnswerForm form) {
  if (form.json) {
    Json json = check_json(scene, answer);
    statics.add_to(json);
    return json_text(json, form);
  }
  if (form.one_line) return fmt::format("{}: {}\n", name, to_string(answer.verdict));
  return check_text(scene, motion, answer) + joints_text(answer) + statics.text();
}

// Of several scenes people are told the verdicts, each on a line.
void require_room_for_statics(const CheckOptions& asked, bool several) {
  if (!several || asked.json || !asked.statics.any()) return;
  throw UsageError(
      "--margin and --ranges: of several scenes only the verdicts are printed; add --json, or ask "
      "for one scene");
}

}  // namespace

Action declare_check(Options& options) {
  auto asked = std::make_shared<CheckOptions>();
  add_scenes(options, asked->scenes, asked->overrides);
  options.flag("--json", "print the answer as JSON", asked->json);
  add_statics_options(options, asked->statics);
  add_threads_option(options, asked->threads, "scenes, or ranges of one,");
  add_solver_options(options, asked->motion);
  return [asked, &options](const Stopwatch&) {
    require_room_for_statics(*asked, asked->scenes.size() > 1);
    const Batch batch{.sources = asked->scenes, .json = asked->json, .threads = asked->threads};
    return for_each_scene(batch, [&](const SceneText& text, AnswerForm form, Notes& notes) {
      require_room_for_statics(*asked, form.one_line);
      if (!form.one_line && !asked->statics.ranges)
        note_idle(options, {"--threads"}, "for one scene without --ranges", notes);
      const Scene scene = parse(text, asked->overrides);
      note_idle_solver(options, scene, notes);
      const Check answer = check(scene, asked->motion);
      StaticsRequest statics_request = asked->statics;
      // Several scenes share the threads.
      if (!form.one_line) statics_request.threads = thread_count(asked->threads);
      statics_request.style = Progress::style_for_stderr(form.one_line);
      const StaticsAnswer statics(scene, asked->motion, statics_request, answer.verdict, notes);
      return Answer{exit_code(answer.verdict),
                    answer_text(text.name, scene, asked->motion, answer, statics, form)};
    });
  };
}

}  // namespace wuerfel
