#pragma once
// Coupling of substepped bodies by sequential impulses (Catto 2005; Mirtich & Canny 1995): contacts with
// Coulomb friction, and ties.

#include <memory>
#include <span>

#include "server/physics/mechanics/coupled/island.h"

namespace prosector {

/// Inputs of a tick. All referenced data outlives the call.
struct SubstepTick {
  std::span<const SoftBodyState> start;         // state of each soft member at the tick's start
  std::span<const char> substepped;             // by soft member: whether it is substepped here
  std::span<const std::size_t> contacts, ties;  // indices of the island's contacts and ties to solve
  int substeps = 1;                             // number of equal substeps
  double h = 0;                                 // s
};

/// Work of impulses on a soft member within the tick, J.
struct SubstepWork {
  double done = 0;  // on the member
  // By the member's contacts on both of their sides together; positive only where overlaps open.
  double made = 0;
};

/// Largest speeds at which overlaps open, m/s. The second is for sheets and ropes, which are light compared
/// with the bodies that press on them.
inline constexpr double opening_speed = 0.25, thin_opening_speed = 0.06;

/// Steps substepped bodies through a tick. Reuses its buffers: allocates only when there are more bodies,
/// contacts or ties than before.
class ImpulseCoupling {
 public:
  ImpulseCoupling();
  ~ImpulseCoupling();
  ImpulseCoupling(ImpulseCoupling&&) noexcept;

  /// Advances the substepped soft members by the tick. Rigid members start with velocity twist/h and constant
  /// inertia; their twists are set to the result of the impulses. An impulse changes the momenta of both
  /// sides by equal and opposite amounts.
  ///
  /// Contacts act before each substep and change velocities only, since moving single nodes would strain the
  /// surrounding elements. They set velocities that bring the gap to 0 at the substep's end, without
  /// restitution. The bodies' own velocity change is predicted from the last substep, so resting bodies
  /// neither sink nor creep. Overlaps open at the opening speeds at most.
  ///
  /// Ties act after each substep, implicitly from its start. A hand's pull, and the ties of its held bodies,
  /// count as inertia k·h²; their effect is spread evenly over the tick, like that of impulses. Contact
  /// forces are means over the tick. `work`: by soft member.
  void run(Island& island, const SubstepTick& tick, std::span<SubstepWork> work);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
