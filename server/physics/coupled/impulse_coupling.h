#pragma once
// Bodies in substeps among rigid ones: sequential impulses (Catto 2005; Mirtich & Canny 1995) over contacts,
// with Coulomb friction, and over ties.

#include <memory>
#include <span>

#include "server/physics/coupled/island.h"

namespace prosector {

/// What the tick is about; all of it outlives the call.
struct SubstepTick {
  std::span<const SoftBodyState> start;         // of each soft member: the tick's start
  std::span<const char> substepped;             // of each soft member: whether it is taken through here
  std::span<const std::size_t> contacts, ties;  // by index, of any members: those to be solved
  int substeps = 1;                             // equal ones
  double h = 0;                                 // s
  Vec3 gravity = Vec3::Zero();                  // m/s²
};

/// Keeps what it works in from tick to tick: allocates only for more bodies, contacts or ties than it has
/// had.
class ImpulseCoupling {
 public:
  ImpulseCoupling();
  ~ImpulseCoupling();
  ImpulseCoupling(ImpulseCoupling&&) noexcept;

  /// Takes the soft members that are substepped through the tick. Rigid members start with the velocity
  /// twist/h and keep their orientation's inertia; their twists are what the impulses left. An impulse
  /// changes the velocities of both sides by equal and opposite momenta, and a substep's positions as if it
  /// had acted from the substep's start: a contact that closes ends the substep at gap 0, without bounce. A
  /// gap that is negative when the tick starts opens at no more than a bounded speed. A held hand's pull
  /// counts as inertia k·h². Contact forces are means over the tick. `work`: J, by impulses on each soft
  /// member.
  void run(Island& island, const SubstepTick& tick, std::span<double> work);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
