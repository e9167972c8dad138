#pragma once
// One tick of an island with soft bodies of different integration methods.

#include <memory>

#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Steps islands, groups of bodies connected by contacts and ties, through a tick. First, implicit and rigid
/// bodies are minimised together (island_solver.h). Then explicit and position-based bodies take equal
/// substeps in lockstep and exchange impulses with the bodies that they touch (impulse_coupling.h).
///
/// A body that needs more substeps than its scene allows is minimised by implicit Euler instead, and its note
/// reports that. The same applies to a body that became too stiff for its substeps within the tick, after one
/// more try. It also applies to a substepped body in contact with a minimised soft body. A body with inverted
/// elements is stepped under the recovery law (recovery.h). Gravity that is not finite counts as zero.
class IslandStepper {
 public:
  IslandStepper();
  ~IslandStepper();
  IslandStepper(IslandStepper&&) noexcept;

  /// Steps all bodies of the island by h s under `gravity` (m/s²). Updates the soft bodies' states, the rigid
  /// bodies' twists, the contact forces, and each soft body's note and flags. Returns the solver's report.
  IslandReport step(Island& island, double h, const Vec3& gravity);

 private:
  struct Buffers;  // buffers for all islands; not state
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace prosector::coupled
