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
  const std::string path = std::string(TEST_DATA) + "/reference/" + stem + ".json";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  ReferenceCase result;
  result.data = nlohmann::json::parse(file);
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
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(TEST_DATA) + "/reference")) {
    const std::string stem = entry.path().stem();
    const bool wanted =
        prefixes.empty()
        || std::ranges::any_of(prefixes, [&](const std::string& p) { return stem.starts_with(p); });
    if (entry.path().extension() != ".json" || !wanted) continue;
    const ReferenceCase found = read_reference_case(stem);
    const bool plain = kind == "friction" || !found.data.contains("extension");
    if (found.kind == kind && plain) names.push_back(stem);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace wuerfel::test
