#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/scene/color.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {
namespace {

/// The fewest digits that bring back the same double; a zero keeps its sign.
std::string number(double value) {
  const std::string digits = fmt::format("{}", value);
  return digits == "-0" ? "-0.0" : digits;
}

std::string numbers(const Vec2& value) {
  return fmt::format("[{},{}]", number(value.x()), number(value.y()));
}

std::string text(const std::string& value) {
  using nlohmann::json;
  return json(value).dump(-1, ' ', false, json::error_handler_t::replace);
}

/// One JSON object, key by key.
class ObjectWriter {
 public:
  void add(std::string_view key, const std::string& value) {
    fmt::format_to(std::back_inserter(json_), "{}\"{}\":{}", json_.size() > 1 ? "," : "", key,
                   value);
  }
  /// What differs from the scene's own material.
  void add_material(const Material& material, const Material& standard) {
    if (material.friction != standard.friction) add("friction", number(material.friction));
    if (material.restitution != standard.restitution)
      add("restitution", number(material.restitution));
  }
  [[nodiscard]] std::string take() const { return json_ + "}"; }

 private:
  std::string json_ = "{";
};

std::string object(const ScenePlane& plane, const Material& standard) {
  ObjectWriter writer;
  writer.add("name", text(plane.name));
  writer.add("point", numbers(plane.point));
  writer.add("normal", numbers(plane.normal));
  writer.add_material(plane.material, standard);
  return writer.take();
}

std::string object(const SceneFixed& fixed, const Material& standard) {
  ObjectWriter writer;
  writer.add("name", text(fixed.name));
  writer.add("size", numbers(fixed.size));
  writer.add("position", numbers(fixed.position));
  writer.add("angle", number(fixed.angle));
  writer.add_material(fixed.material, standard);
  return writer.take();
}

std::string object(const SceneCube& cube, const Material& standard) {
  ObjectWriter writer;
  writer.add("name", text(cube.name));
  writer.add("size", numbers(cube.size));
  writer.add("mass", number(cube.mass));
  writer.add("position", numbers(cube.position));
  writer.add("angle", number(cube.angle));
  writer.add("velocity", numbers(cube.velocity));
  writer.add("spin", number(cube.spin));
  writer.add_material(cube.material, standard);
  if (cube.color) writer.add("color", text(color_text(*cube.color)));
  return writer.take();
}

std::string object(const ScenePair& pair, const Material& /*standard*/) {
  ObjectWriter writer;
  writer.add("bodies", fmt::format("[{},{}]", text(pair.bodies[0]), text(pair.bodies[1])));
  if (pair.friction) writer.add("friction", number(*pair.friction));
  if (pair.restitution) writer.add("restitution", number(*pair.restitution));
  return writer.take();
}

std::string object(const ScenePoint& point, const Material& /*standard*/) {
  ObjectWriter writer;
  writer.add("name", text(point.name));
  writer.add("mass", number(point.mass));
  writer.add("position", numbers(point.position));
  writer.add("velocity", numbers(point.velocity));
  return writer.take();
}

std::string place_text(const ScenePlace& place) {
  if (place.body.empty()) return numbers(place.at);
  ObjectWriter writer;
  writer.add("body", text(place.body));
  writer.add("at", numbers(place.at));
  return writer.take();
}

std::string object(const SceneRod& rod, const Material& /*standard*/) {
  ObjectWriter writer;
  writer.add("name", text(rod.name));
  writer.add("from", place_text(rod.from));
  writer.add("to", place_text(rod.to));
  writer.add("length", number(rod.length));
  return writer.take();
}

std::string object(const ScenePin& pin, const Material& /*standard*/) {
  ObjectWriter writer;
  writer.add("name", text(pin.name));
  writer.add("from", place_text(pin.from));
  writer.add("to", place_text(pin.to));
  if (pin.collide) writer.add("collide", "true");
  return writer.take();
}

template <class Body>
void add_all(ObjectWriter& writer,
             std::string_view key,
             const std::vector<Body>& bodies,
             const Material& standard) {
  if (bodies.empty()) return;
  std::string list = "[";
  for (const Body& body : bodies) {
    if (list.size() > 1) list += ",";
    list += object(body, standard);
  }
  writer.add(key, list + "]");
}

}  // namespace

std::string normalised_scene(const Scene& scene) {
  ObjectWriter material;
  material.add("friction", number(scene.material.friction));
  material.add("restitution", number(scene.material.restitution));
  ObjectWriter writer;
  writer.add("version", "1");
  writer.add("title", text(scene.title));
  writer.add("gravity", numbers(scene.gravity));
  writer.add("duration", number(scene.duration));
  writer.add("material", material.take());
  add_all(writer, "plane", scene.planes, scene.material);
  add_all(writer, "fixed", scene.fixed, scene.material);
  add_all(writer, "cube", scene.cubes, scene.material);
  add_all(writer, "pair", scene.pairs, scene.material);
  add_all(writer, "point", scene.points, scene.material);
  add_all(writer, "rod", scene.rods, scene.material);
  add_all(writer, "pin", scene.pins, scene.material);
  return writer.take();
}

}  // namespace wuerfel
