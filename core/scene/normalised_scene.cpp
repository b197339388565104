#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "core/scene/color.h"
#include "core/scene/json_string.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {
namespace {

/// The fewest digits that bring back the same double; a zero keeps its sign.
void append(double value, std::string& json) {
  const std::size_t start = json.size();
  fmt::format_to(std::back_inserter(json), "{}", value);
  if (std::string_view(json).substr(start) == "-0") json += ".0";
}

void append(const Vec2& value, std::string& json) {
  json += '[';
  append(value.x(), json);
  json += ',';
  append(value.y(), json);
  json += ']';
}

void append(const std::string& text, std::string& json) { json += json_string(text); }

void append(const ScenePlace& place, std::string& json);

/// One JSON object at the end of a text, key by key, until `end`.
class ObjectWriter {
 public:
  explicit ObjectWriter(std::string& json) : json_(json) { json_ += '{'; }

  /// A key, whose value the caller appends.
  std::string& begin(std::string_view key) {
    if (json_.back() != '{') json_ += ',';
    json_.append("\"").append(key).append("\":");
    return json_;
  }
  void add(std::string_view key, const auto& value) { append(value, begin(key)); }
  /// What differs from the scene's own material.
  void add_material(const Material& material, const Material& standard) {
    if (material.friction != standard.friction) add("friction", material.friction);
    if (material.restitution != standard.restitution) add("restitution", material.restitution);
  }
  void end() { json_ += '}'; }

 private:
  std::string& json_;
};

void write(const ScenePlane& plane, const Material& standard, ObjectWriter& writer) {
  writer.add("name", plane.name);
  writer.add("point", plane.point);
  writer.add("normal", plane.normal);
  writer.add_material(plane.material, standard);
}

void write(const SceneFixed& fixed, const Material& standard, ObjectWriter& writer) {
  writer.add("name", fixed.name);
  writer.add("size", fixed.size);
  writer.add("position", fixed.position);
  writer.add("angle", fixed.angle);
  writer.add_material(fixed.material, standard);
}

void write(const SceneCube& cube, const Material& standard, ObjectWriter& writer) {
  writer.add("name", cube.name);
  writer.add("size", cube.size);
  writer.add("mass", cube.mass);
  writer.add("position", cube.position);
  writer.add("angle", cube.angle);
  writer.add("velocity", cube.velocity);
  writer.add("spin", cube.spin);
  writer.add_material(cube.material, standard);
  if (cube.color) writer.add("color", color_text(*cube.color));
}

void write(const ScenePair& pair, const Material& /*standard*/, ObjectWriter& writer) {
  writer.begin("bodies") +=
      fmt::format("[{},{}]", json_string(pair.bodies[0]), json_string(pair.bodies[1]));
  if (pair.friction) writer.add("friction", *pair.friction);
  if (pair.restitution) writer.add("restitution", *pair.restitution);
}

void write(const ScenePoint& point, const Material& /*standard*/, ObjectWriter& writer) {
  writer.add("name", point.name);
  writer.add("mass", point.mass);
  writer.add("position", point.position);
  writer.add("velocity", point.velocity);
}

void append(const ScenePlace& place, std::string& json) {
  if (place.body.empty()) return append(place.at, json);
  ObjectWriter writer(json);
  writer.add("body", place.body);
  writer.add("at", place.at);
  writer.end();
}

void write(const SceneRod& rod, const Material& /*standard*/, ObjectWriter& writer) {
  writer.add("name", rod.name);
  writer.add("from", rod.from);
  writer.add("to", rod.to);
  writer.add("length", rod.length);
}

void write(const ScenePin& pin, const Material& /*standard*/, ObjectWriter& writer) {
  writer.add("name", pin.name);
  writer.add("from", pin.from);
  writer.add("to", pin.to);
  if (pin.collide) writer.begin("collide") += "true";
}

template <class Body>
void add_all(ObjectWriter& writer,
             std::string_view key,
             const std::vector<Body>& bodies,
             const Material& standard) {
  if (bodies.empty()) return;
  std::string& json = writer.begin(key);
  for (const Body& body : bodies) {
    json += &body == bodies.data() ? '[' : ',';
    ObjectWriter item(json);
    write(body, standard, item);
    item.end();
  }
  json += ']';
}

}  // namespace

std::string normalised_scene(const Scene& scene) {
  std::string json;
  ObjectWriter writer(json);
  writer.begin("version") += '1';
  writer.add("title", scene.title);
  writer.add("gravity", scene.gravity);
  writer.add("duration", scene.duration);
  ObjectWriter material(writer.begin("material"));
  material.add("friction", scene.material.friction);
  material.add("restitution", scene.material.restitution);
  material.end();
  add_all(writer, "plane", scene.planes, scene.material);
  add_all(writer, "fixed", scene.fixed, scene.material);
  add_all(writer, "cube", scene.cubes, scene.material);
  add_all(writer, "pair", scene.pairs, scene.material);
  add_all(writer, "point", scene.points, scene.material);
  add_all(writer, "rod", scene.rods, scene.material);
  add_all(writer, "pin", scene.pins, scene.material);
  writer.end();
  return json;
}

}  // namespace wuerfel
