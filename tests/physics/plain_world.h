#pragma once
// Bullet alone, set up as its documentation does: what ours is compared with.

#include <memory>

#include "common/scene/scene.h"
#include "server/physics/simulation.h"

namespace prosector::test {

/// The scene's rigid bodies, whose first part is a box or a sphere and their only one.
class PlainWorld {
 public:
  explicit PlainWorld(const SceneDesc& scene);
  ~PlainWorld();
  /// One tick of the scene, in one step.
  void step();
  RigidBodyState state(std::size_t body) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector::test
