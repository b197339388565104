#include "core/check.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/output/text_output.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

Json check_json(const Scene& scene, const Check& answer) {
  Json accelerations = Json::object();
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    const Twist& a = answer.accelerations[i];
    accelerations[scene.cubes[i].name] = {
        {"ax", a.linear.x()}, {"ay", a.linear.y()}, {"alpha", a.angular}};
  }
  Json contacts = Json::array();
  for (const ContactForce& contact : answer.contacts) {
    contacts.push_back({{"on", contact.on},
                        {"from", contact.from},
                        {"point", {contact.point.x(), contact.point.y()}},
                        {"normal", {contact.normal.x(), contact.normal.y()}},
                        {"force", contact.force},
                        {"tangential", contact.tangential},
                        {"unique", contact.unique}});
  }
  return {{"verdict", to_string(answer.verdict)},
          {"accelerations", std::move(accelerations)},
          {"contacts", std::move(contacts)},
          {"objective", answer.objective},
          {"kkt_residual", answer.kkt_residual}};
}

// For people: the verdict, who accelerates most, and what presses where.
std::string check_text(const Scene& scene, const Check& answer) {
  std::string text = fmt::format("{}\n", to_string(answer.verdict));
  // Of a turning cube the corners are fastest, at half a diagonal from the centre.
  const auto severity = [&](std::size_t i) {
    const Twist& a = answer.accelerations[i];
    return a.linear.norm() + 0.5 * scene.cubes[i].size.norm() * std::abs(a.angular);
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < scene.cubes.size(); ++i) {
    if (severity(i) > severity(worst)) worst = i;
  }
  if (!scene.cubes.empty()) {
    const Twist& a = answer.accelerations[worst];
    text += fmt::format("largest acceleration: {} with ({:.6g}, {:.6g}) m/s^2 and {:.6g} rad/s^2\n",
                        scene.cubes[worst].name, a.linear.x(), a.linear.y(), a.angular);
  }
  if (!answer.contacts.empty()) {
    text += fmt::format("\n{:<14} {:<14} {:>10} {:>10} {:>12} {:>12}\n", "on", "from", "x / m",
                        "y / m", "force / N", "along / N");
  }
  for (const ContactForce& contact : answer.contacts) {
    text += fmt::format("{:<14} {:<14} {:>10.4g} {:>10.4g} {:>12.6g} {:>12.6g}{}\n", contact.on,
                        contact.from, contact.point.x(), contact.point.y(), contact.force,
                        contact.tangential, contact.unique ? "" : "  not the only one possible");
  }
  return text;
}

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

}  // namespace

ExitCode check(const CheckOptions& options) {
  const Scene scene = read_scene(options.scene);
  const Check answer = check(scene, options.motion);
  write_text("-",
             options.json ? check_json(scene, answer).dump(2) + "\n" : check_text(scene, answer));
  return exit_code(answer.verdict);
}

}  // namespace wuerfel
