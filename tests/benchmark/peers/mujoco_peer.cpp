// MuJoCo 2.2: soft contacts, Newton solver. Boxes are held to the plane by two slides and a hinge.
#include <array>
#include <cstring>
#include <mujoco/mujoco.h>
#include <stdexcept>

#include <fmt/core.h>

#include "tests/benchmark/peers/peer.h"

namespace wuerfel::bench {

namespace {

struct Variant {
  bool stiff = false;  ///< contact time constant of two steps instead of 0.02 s
  bool runge_kutta = false;
};

// x and z of MuJoCo are our x and y; the hinge turns about -y, so that angles are ours.
std::string model_text(const Scene& scene, double step, const Variant& variant) {
  // Buffers of this many contacts are cleared whenever a world is made: no more than needed.
  const std::size_t room = 20 * (scene.cubes.size() + 1);
  std::string text = fmt::format(
      "<mujoco><compiler angle=\"radian\"/><size njmax=\"{}\" nconmax=\"{}\"/>"
      "<option timestep=\"{}\" gravity=\"{} 0 {}\" solver=\"Newton\" tolerance=\"1e-8\" "
      "integrator=\"{}\"/><default><geom type=\"box\" condim=\"1\" friction=\"0 0 0\"{}/></default>"
      "<worldbody>",
      room, room, step, scene.gravity.x(), scene.gravity.y(), variant.runge_kutta ? "RK4" : "Euler",
      variant.stiff ? fmt::format(" solref=\"{} 1\" solimp=\"0.99 0.9999 0.0001\"", 2.0 * step)
                    : std::string{});
  for (const SceneFixed& fixed : all_fixed(scene))
    text +=
        fmt::format("<geom pos=\"{} 0 {}\" euler=\"0 {} 0\" size=\"{} 1 {}\"/>", fixed.position.x(),
                    fixed.position.y(), -fixed.angle, 0.5 * fixed.size.x(), 0.5 * fixed.size.y());
  for (const SceneCube& cube : scene.cubes)
    text += fmt::format(
        "<body pos=\"{} 0 {}\"><joint type=\"slide\" axis=\"1 0 0\"/><joint type=\"slide\" "
        "axis=\"0 0 1\"/><joint type=\"hinge\" axis=\"0 -1 0\"/><geom mass=\"{}\" size=\"{} 0.5 "
        "{}\"/></body>",
        cube.position.x(), cube.position.y(), cube.mass, 0.5 * cube.size.x(), 0.5 * cube.size.y());
  return text + "</worldbody></mujoco>";
}

using ModelPointer = std::shared_ptr<mjModel>;

ModelPointer compile(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const char* name = "scene.xml";
  mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], text.data(), text.size());
  std::array<char, 1000> error{};
  ModelPointer model(mj_loadXML(name, files.get(), error.data(), error.size()), mj_deleteModel);
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(fmt::format("MuJoCo: {}", error.data()));
  return model;
}

class MujocoWorld : public PeerWorld {
 public:
  MujocoWorld(ModelPointer model, const Scene& scene)
      : scene_(scene), model_(std::move(model)), data_(mj_makeData(model_.get()), mj_deleteData) {
    for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
      const SceneCube& cube = scene.cubes[i];
      data_->qpos[3 * i + 2] = cube.angle;
      data_->qvel[3 * i] = cube.velocity.x();
      data_->qvel[3 * i + 1] = cube.velocity.y();
      data_->qvel[3 * i + 2] = cube.spin;
    }
  }

  void step() override { mj_step(model_.get(), data_.get()); }

  [[nodiscard]] State states() const override {
    State state;
    for (std::size_t i = 0; i < scene_.cubes.size(); ++i) {
      const mjtNum* q = data_->qpos + 3 * i;
      const mjtNum* v = data_->qvel + 3 * i;
      state.push_back({scene_.cubes[i].position + Vec2(q[0], q[1]), q[2], {v[0], v[1]}, v[2]});
    }
    return state;
  }

 private:
  const Scene& scene_;
  ModelPointer model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
};

}  // namespace

std::vector<Peer> mujoco_peers() {
  const std::string engine = "MuJoCo 2.2.2";
  const auto make = [](const Variant& variant) {
    return [variant](const Scene& scene, double step) -> Peer::Maker {
      const ModelPointer model = compile(model_text(scene, step, variant));
      return [&scene, model] { return std::make_unique<MujocoWorld>(model, scene); };
    };
  };
  return {{engine, "default", 30, make({false, false}), false},
          {engine, "stiff", 30, make({true, false}), false},
          {engine, "stiff, RK4", 3, make({true, true}), false}};
}

}  // namespace wuerfel::bench
