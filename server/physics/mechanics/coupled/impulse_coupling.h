#pragma once
// Coupling of substepped bodies by sequential impulses (Catto 2005; Mirtich & Canny 1995): contacts with
// Coulomb friction, and ties.

#include <memory>
#include <span>

#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Inputs for stepping an island's substepped bodies through one tick: the soft bodies' states at its start,
/// the contacts and ties to solve, and the number of substeps. All referenced data must outlive the call.
struct SubstepTick {
  std::span<const soft::SoftBodyState> start;   // state of each soft member at the tick's start
  std::span<const char> substepped;             // by soft member: whether it is substepped here
  std::span<const std::size_t> contacts, ties;  // indices of the island's contacts and ties to solve
  int substeps = 1;                             // number of equal substeps
  double h = 0;                                 // s
};

/// Work (J) of contact and tie impulses on one soft body within a tick, and the part that its contacts
/// created by pushing overlapping bodies apart.
struct SubstepWork {
  double done = 0;  // on the member
  // By the member's contacts on both of their sides together; positive only where overlaps open.
  double made = 0;
};

/// Largest speeds (m/s) at which contact impulses push overlapping bodies apart. `thin_opening_speed` applies
/// to sheets and ropes, which are light compared with the bodies that press on them.
inline constexpr double opening_speed = 0.25, thin_opening_speed = 0.06;

/// Steps the bodies of an island that are integrated in substeps (explicit or position-based) through a tick,
/// with contacts and ties solved by impulses. Its buffers are reused, and grow only with the number of
/// bodies, contacts or ties.
class ImpulseCoupling {
 public:
  ImpulseCoupling();
  ~ImpulseCoupling();
  ImpulseCoupling(ImpulseCoupling&&) noexcept;

  /// Advances the island's substepped soft bodies by one tick. Rigid bodies start with velocity twist/h and
  /// have constant inertia; their twists are set to the result of the impulses. Each impulse changes the
  /// momenta of both sides by equal and opposite amounts.
  ///
  /// Contact impulses act before each substep and change velocities only, since moving single nodes would
  /// strain the surrounding elements. They bring the gap to 0 at the substep's end, without restitution.
  /// Overlaps open at most at `opening_speed`. Each body's velocity change without impulses is predicted from
  /// its last substep, so resting bodies neither sink nor creep.
  ///
  /// Tie impulses act after each substep and are integrated implicitly from its start. A hand's pull, and the
  /// ties of bodies that it holds, count as inertia k·h² (k: stiffness) and are spread evenly over the tick.
  /// Contact forces are set to means over the tick. `work` receives the work of impulses on each soft body.
  void run(Island& island, const SubstepTick& tick, std::span<SubstepWork> work);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector::coupled
