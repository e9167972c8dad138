#pragma once
// Bodies in substeps among rigid ones: sequential impulses (Catto 2005; Mirtich & Canny 1995) over contacts,
// with Coulomb friction, and over ties.

#include <memory>
#include <span>

#include "server/physics/island.h"

namespace prosector {

/// What the tick is about; all of it outlives the call.
struct SubstepTick {
  std::span<const SoftBodyState> start;         // of each soft member: the tick's start
  std::span<const char> substepped;             // of each soft member: whether it is taken through here
  std::span<const std::size_t> contacts, ties;  // by index, of any members: those to be solved
  int substeps = 1;                             // equal ones
  double h = 0;                                 // s
};

/// J, what impulses did to a soft member within the tick.
struct SubstepWork {
  double done = 0;  // on it
  double made = 0;  // by its contacts on both of their sides: bodies that strike each other get none
};

/// m/s, at most, of what overlaps; of sheets and ropes, which are light for what presses on them.
inline constexpr double opening_speed = 0.25, thin_opening_speed = 0.06;

/// Keeps what it works in from tick to tick: allocates only for more bodies, contacts or ties than it has
/// had.
class ImpulseCoupling {
 public:
  ImpulseCoupling();
  ~ImpulseCoupling();
  ImpulseCoupling(ImpulseCoupling&&) noexcept;

  /// Takes the soft members that are substepped through the tick. Rigid members start with the velocity
  /// twist/h and keep their orientation's inertia; their twists are what the impulses left. An impulse
  /// changes the velocities of both sides by equal and opposite momenta. Contacts act before each substep and
  /// move nothing: an impulse that moved single nodes would strain what they hang on, for nothing. They leave
  /// velocities that take the gap to 0 at the substep's end, without bounce, if the bodies then do by
  /// themselves what they did in the last one. So what rests neither sinks nor creeps. Overlaps open at those
  /// speeds at most. Ties act after it, as if from its start. A hand's pull counts as inertia k·h², and so do
  /// the ties of what it holds; what they do to both comes evenly over the tick, as impulses do. Contact
  /// forces are means over the tick. `work`: by soft member.
  void run(Island& island, const SubstepTick& tick, std::span<SubstepWork> work);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
