#pragma once
// One tick of an island whose soft bodies may be of several kinds.

#include <memory>

#include "server/physics/island.h"

namespace prosector {

/// Steps islands. Implicit bodies and rigid ones are minimised together (island_solver.h). Then bodies with a
/// substepper of their own (explicit, position-based) go through the tick in equal substeps, all of the
/// island in step. They exchange equal and opposite impulses with what they touch (impulse_coupling.h). A
/// body that would need more substeps than its scene allows is minimised instead, by implicit Euler, and says
/// so. So is one that got stiffer within the tick than its substeps bear, after one more try, and one that
/// touches a soft body that is minimised. A ruined body is stepped under the law that leads out (recovery.h).
/// Gravity that is not finite counts as none.
class IslandStepper {
 public:
  IslandStepper();
  ~IslandStepper();
  IslandStepper(IslandStepper&&) noexcept;

  /// Steps the island by h s. Fills twists, contact forces and each member's results.
  IslandReport step(Island& island, double h, const Vec3& gravity);

 private:
  struct Buffers;  // what ticks of any island work in: nothing of it is state
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace prosector
