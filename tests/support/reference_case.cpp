#include "tests/support/reference_case.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace wuerfel::test {
namespace {

Vec2 vec2(const nlohmann::json& pair) {
  return {pair.at(0).get<double>(), pair.at(1).get<double>()};
}

SceneCube read_cube(const nlohmann::json& body) {
  SceneCube cube;
  cube.name = body.at("id");
  cube.size = {body.at("shape").at("width").get<double>(),
               body.at("shape").at("height").get<double>()};
  cube.mass = body.at("mass");
  const auto& state = body.at("state");
  cube.position = {state.at("x").get<double>(), state.at("y").get<double>()};
  cube.angle = state.at("theta");
  cube.velocity = {state.at("vx").get<double>(), state.at("vy").get<double>()};
  cube.spin = state.at("omega");
  return cube;
}

double number_or_zero(const nlohmann::json& data, const std::string& key) {
  return data.contains(key) && data.at(key).is_number() ? data.at(key).get<double>() : 0.0;
}

void set_surfaces(const nlohmann::json& data, Scene& scene) {
  const Material material{number_or_zero(data, "mu"), number_or_zero(data, "e")};
  for (SceneCube& cube : scene.cubes)
    cube.material = material;
  for (ScenePlane& plane : scene.planes)
    plane.material = material;
  for (SceneFixed& fixed : scene.fixed)
    fixed.material = material;
  for (const auto& pair : data.value("pair_mu", nlohmann::json::array())) {
    const auto& bodies = pair.at("bodies");
    scene.pairs.push_back({{bodies.at(0), bodies.at(1)}, pair.at("mu").get<double>(), {}});
  }
}

Scene read_scene(const nlohmann::json& data) {
  Scene scene;
  scene.title = data.at("name");
  if (data.contains("gravity")) scene.gravity = vec2(data.at("gravity"));
  for (const auto& body : data.value("bodies", nlohmann::json::array())) {
    scene.cubes.push_back(read_cube(body));
  }
  for (const auto& object : data.value("static", nlohmann::json::array())) {
    if (object.at("type") == "halfplane") {
      scene.planes.push_back(
          {object.at("id"), vec2(object.at("point")), vec2(object.at("normal")).normalized(), {}});
    } else {
      scene.fixed.push_back({object.at("id"),
                             {object.at("width").get<double>(), object.at("height").get<double>()},
                             {object.at("x").get<double>(), object.at("y").get<double>()},
                             object.at("theta"),
                             {}});
    }
  }
  set_surfaces(data, scene);
  return scene;
}

nlohmann::json read_data(const std::string& stem) {
  const std::string path = std::string(TEST_DATA) + "/reference/" + stem + ".json";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  return nlohmann::json::parse(file);
}

/// What names of cases are chosen by.
struct Listed {
  std::string stem;
  std::string kind;
  bool extended = false;  ///< needs friction or restitution
};

/// In order. Read once: every test of the suite is a process that begins with the names.
std::vector<Listed> list_cases() {
  std::vector<Listed> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(TEST_DATA) + "/reference")) {
    if (entry.path().extension() != ".json") continue;
    const std::string stem = entry.path().stem();
    const nlohmann::json data = read_data(stem);
    all.push_back({stem, data.at("kind"), data.contains("extension")});
  }
  std::ranges::sort(all, {}, &Listed::stem);
  return all;
}

}  // namespace

int ReferenceCase::cube(const std::string& id) const {
  const auto found = std::ranges::find(scene.cubes, id, &SceneCube::name);
  if (found == scene.cubes.end()) throw std::out_of_range(name + ": no body " + id);
  return static_cast<int>(found - scene.cubes.begin());
}

double ReferenceCase::weight() const {
  double mass = 0.0;
  for (const SceneCube& cube : scene.cubes)
    mass += cube.mass;
  return mass * scene.gravity.norm();
}

ReferenceCase read_reference_case(const std::string& stem) {
  ReferenceCase result;
  result.data = read_data(stem);
  result.name = result.data.at("name");
  result.kind = result.data.at("kind");
  result.scene = read_scene(result.data);
  return result;
}

std::string test_name(std::string stem) {
  std::ranges::replace_if(
      stem, [](char c) { return c == '.' || c == '-'; }, '_');
  return stem;
}

std::vector<std::string> reference_case_names(const std::string& kind,
                                              const std::vector<std::string>& prefixes) {
  static const std::vector<Listed> all = list_cases();
  std::vector<std::string> names;
  for (const Listed& listed : all) {
    const bool wanted =
        prefixes.empty() || std::ranges::any_of(prefixes, [&](const std::string& p) {
          return listed.stem.starts_with(p);
        });
    const bool plain = kind == "friction" || !listed.extended;
    if (wanted && plain && listed.kind == kind) names.push_back(listed.stem);
  }
  return names;
}

}  // namespace wuerfel::test
