#pragma once
// Bodies in substeps among rigid ones: sequential impulses (Catto 2005; Mirtich & Canny 1995) over contacts,
// with Coulomb friction, and over ties.

#include <span>
#include <vector>

#include "server/physics/coupled/island.h"

namespace prosector {

/// `before`: each soft member's node positions at the tick's start. Takes the soft members that `substepped`
/// marks through h seconds in `substeps` equal steps. Rigid members start with the velocity twist/h and keep
/// their orientation's inertia; their twists are what the impulses left. Of `contacts` and `ties`, those
/// given by index are solved, which may join any members. An impulse changes the velocities of both sides by
/// equal and opposite momenta, and a substep's positions as if it had acted from the substep's start: a
/// contact that closes ends the substep at gap 0, without bounce. A gap that is negative when the tick starts
/// opens at no more than a bounded speed. A held hand's pull counts as inertia k·h². Contact forces are means
/// over the tick.
void couple_by_impulses(Island& island, std::span<const VecX> before, std::span<const char> substepped,
                        std::span<const std::size_t> contacts, std::span<const std::size_t> ties,
                        int substeps, double h, const Vec3& gravity, std::span<double> work);

}  // namespace prosector
