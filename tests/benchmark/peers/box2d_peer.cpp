// Box2D 2.4: single precision, sequential impulses, a skin of 1 cm around every polygon.
#include <box2d/box2d.h>

#include "tests/benchmark/peers/peer.h"

namespace wuerfel::bench {

namespace {

struct Iterations {
  int velocity = 8;
  int position = 3;
  bool skin = true;  ///< false: polygon radius 0, which breaks continuous collision
};

b2Vec2 vec(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

class Box2dWorld : public PeerWorld {
 public:
  Box2dWorld(const Scene& scene, double step, const Iterations& iterations)
      : world_(vec(scene.gravity)), step_(static_cast<float>(step)), iterations_(iterations) {
    world_.SetAllowSleeping(false);
    for (const SceneFixed& fixed : all_fixed(scene)) {
      b2BodyDef definition;
      definition.position = vec(fixed.position);
      definition.angle = static_cast<float>(fixed.angle);
      add_box(*world_.CreateBody(&definition), fixed.size, 0.0, fixed.material);
    }
    for (const SceneCube& cube : scene.cubes) {
      b2BodyDef definition;
      definition.type = b2_dynamicBody;
      definition.position = vec(cube.position);
      definition.angle = static_cast<float>(cube.angle);
      definition.linearVelocity = vec(cube.velocity);
      definition.angularVelocity = static_cast<float>(cube.spin);
      cubes_.push_back(world_.CreateBody(&definition));
      add_box(*cubes_.back(), cube.size, cube.mass / cube.size.prod(), cube.material);
    }
  }

  void step() override { world_.Step(step_, iterations_.velocity, iterations_.position); }

  [[nodiscard]] State states() const override {
    State state;
    for (const b2Body* body : cubes_) {
      const b2Vec2 p = body->GetPosition();
      const b2Vec2 v = body->GetLinearVelocity();
      state.push_back({{double{p.x}, double{p.y}},
                       double{body->GetAngle()},
                       {double{v.x}, double{v.y}},
                       double{body->GetAngularVelocity()}});
    }
    return state;
  }

 private:
  void add_box(b2Body& body, const Vec2& size, double density, const Material& material) const {
    b2PolygonShape shape;
    const b2Vec2 half = vec(0.5 * size);
    shape.SetAsBox(half.x, half.y);
    if (!iterations_.skin) shape.m_radius = 0.0F;
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = static_cast<float>(density);
    fixture.friction = static_cast<float>(material.friction);  // a pair: geometric mean, as ours
    fixture.restitution = 0.0F;
    body.CreateFixture(&fixture);
  }

  b2World world_;
  float step_;
  Iterations iterations_;
  std::vector<b2Body*> cubes_;
};

}  // namespace

std::vector<Peer> box2d_peers() {
  const std::string engine = "Box2D 2.4.1";
  const auto make = [](const Iterations& iterations) {
    return [iterations](const Scene& scene, double step) -> Peer::Maker {
      return [&scene, step, iterations] {
        return std::make_unique<Box2dWorld>(scene, step, iterations);
      };
    };
  };
  return {{engine, "8+3", 2000, make({8, 3, true})},
          {engine, "8+3, no skin", 2000, make({8, 3, false})},
          {engine, "50+20, no skin", 100, make({50, 20, false})}};
}

}  // namespace wuerfel::bench
