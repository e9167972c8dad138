#pragma once
// Restores a simulation's saved state in a second simulation of the same scene.

#include <string>

#include "common/error.h"
#include "server/physics/simulation.h"

namespace prosector::test {

class SaveCheck {
 public:
  /// Compiles the second simulation. `scene` and `options` must be the first one's.
  SaveCheck(const SceneDesc& scene, const CompileOptions& options) : twin_(scene, options) {}

  /// Returns why the saved state, or what the restored one is saved as, can't be restored. Empty: both can.
  /// Their bytes may differ: Bullet rounds orientations when they are set.
  std::string look(const Simulation& simulation) {
    try {
      twin_.restore(simulation.save());
      twin_.restore(twin_.save());
      return {};
    } catch (const InputError& error) {
      return "tick " + std::to_string(simulation.time().tick) + ": " + error.what();
    }
  }

 private:
  Simulation twin_;
};

}  // namespace prosector::test
