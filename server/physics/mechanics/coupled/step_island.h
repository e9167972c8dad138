#pragma once
// One tick of an island with soft bodies of different integration methods.

#include <memory>

#include "server/physics/mechanics/coupled/island.h"

namespace prosector {

/// Steps islands. First, implicit and rigid bodies are minimised together (island_solver.h). Then bodies with
/// their own substepper (explicit, position-based) take equal substeps through the tick, all in lockstep.
/// They exchange equal and opposite impulses with their contacts (impulse_coupling.h).
///
/// A body that needs more substeps than its scene allows is minimised by implicit Euler instead, and its note
/// reports it. So is a body that became too stiff for its substeps within the tick, after one more try. So is
/// a body in contact with a minimised soft body. A ruined body is stepped under the recovery law
/// (recovery.h). Gravity that is not finite counts as zero.
class IslandStepper {
 public:
  IslandStepper();
  ~IslandStepper();
  IslandStepper(IslandStepper&&) noexcept;

  /// Steps the island by h s. Sets twists, contact forces and each member's results.
  IslandReport step(Island& island, double h, const Vec3& gravity);

 private:
  struct Buffers;  // buffers for all islands; not state
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace prosector
