// Chipmunk 7: double precision, sequential impulses, no continuous collision.
#include <chipmunk/chipmunk.h>
#include <cmath>

#include "tests/benchmark/peers/peer.h"

namespace wuerfel::bench {

namespace {

constexpr double slop = 1e-3;  // m, overlap that is left alone; Chipmunk's own 0.1 is for pixels

cpVect vec(const Vec2& v) { return cpv(v.x(), v.y()); }

class ChipmunkWorld : public PeerWorld {
 public:
  ChipmunkWorld(const Scene& scene, double step, int iterations)
      : space_(cpSpaceNew()), step_(step) {
    cpSpaceSetGravity(space_, vec(scene.gravity));
    cpSpaceSetIterations(space_, iterations);
    cpSpaceSetCollisionSlop(space_, slop);
    for (const SceneFixed& fixed : all_fixed(scene)) {
      cpBody* body = cpSpaceAddBody(space_, cpBodyNewStatic());
      cpBodySetPosition(body, vec(fixed.position));
      cpBodySetAngle(body, fixed.angle);
      bodies_.push_back(body);
      add_box(body, fixed.size, fixed.material);
    }
    for (const SceneCube& cube : scene.cubes) {
      const Vec2& size = cube.size;
      cpBody* body = cpSpaceAddBody(
          space_, cpBodyNew(cube.mass, cpMomentForBox(cube.mass, size.x(), size.y())));
      cpBodySetPosition(body, vec(cube.position));
      cpBodySetAngle(body, cube.angle);
      cpBodySetVelocity(body, vec(cube.velocity));
      cpBodySetAngularVelocity(body, cube.spin);
      bodies_.push_back(body);
      cubes_.push_back(body);
      add_box(body, size, cube.material);
    }
  }
  ~ChipmunkWorld() override {
    for (cpShape* shape : shapes_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    for (cpBody* body : bodies_) {
      cpSpaceRemoveBody(space_, body);
      cpBodyFree(body);
    }
    cpSpaceFree(space_);
  }
  ChipmunkWorld(const ChipmunkWorld&) = delete;
  ChipmunkWorld& operator=(const ChipmunkWorld&) = delete;

  void step() override { cpSpaceStep(space_, step_); }

  [[nodiscard]] State states() const override {
    State state;
    for (const cpBody* body : cubes_) {
      const cpVect p = cpBodyGetPosition(body);
      const cpVect v = cpBodyGetVelocity(body);
      state.push_back(
          {{p.x, p.y}, cpBodyGetAngle(body), {v.x, v.y}, cpBodyGetAngularVelocity(body)});
    }
    return state;
  }

 private:
  void add_box(cpBody* body, const Vec2& size, const Material& material) {
    cpShape* shape = cpSpaceAddShape(space_, cpBoxShapeNew(body, size.x(), size.y(), 0.0));
    cpShapeSetFriction(shape, std::sqrt(material.friction));  // a pair: the product
    cpShapeSetElasticity(shape, 0.0);
    shapes_.push_back(shape);
  }

  cpSpace* space_;
  double step_;
  std::vector<cpBody*> bodies_;
  std::vector<cpBody*> cubes_;
  std::vector<cpShape*> shapes_;
};

}  // namespace

std::vector<Peer> chipmunk_peers() {
  const std::string engine = "Chipmunk 7.0.3";
  const auto make = [](int iterations) {
    return [iterations](const Scene& scene, double step) -> Peer::Maker {
      return [&scene, step, iterations] {
        return std::make_unique<ChipmunkWorld>(scene, step, iterations);
      };
    };
  };
  return {{engine, "10", 2000, make(10)}, {engine, "100", 100, make(100)}};
}

}  // namespace wuerfel::bench
