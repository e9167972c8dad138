#pragma once
// Ways out of ruined shapes.
//
// Most laws have minima besides the rest shape: a mirrored body under St. Venant and Kirchhoff's stores
// nothing, a neo-Hookean one that was thrown into a point stays there, and springs don't know inside from
// outside. The corotational law has none that was ever met. So a body with elements inside out or flat is
// stepped under that law, with the same constants, until it is whole again. A body under fem_linear that has
// turned as a whole is stepped under it too, because that law then takes every turn for a strain. What even
// so comes to rest in another shape than its own is unfolded: a reset. So is what a law for small rotations
// takes for a turned body at rest, which is longer than it should be.

#include "server/physics/island.h"

namespace prosector {

/// Decides before a tick of h s under which law the body goes through it (SoftBodyState::recovering), and
/// says so in the member. A switch forgets the step before.
void choose_law(SoftMember& member, double h);

/// Tells whether a quiet body may stay as it is: neither tangled nor inside out, and under the law it will
/// keep.
bool may_sleep(const SoftMember& member);

/// After a tick: counts how long the body has been quiet, towards sleep.
inline constexpr int quiet_ticks_to_sleep = 30;
void count_quiet_ticks(SoftMember& member);

/// What is about a body that may be unfolded.
struct Surroundings {
  bool jammed = false;   // between a hand, or tissue in a hand, and other tissue
  bool crushed = false;  // jammed, in a hand or between rigid things: it may have another volume for good
  bool blind = false;    // deep in tissue that it can't be led out of, because what is inside out is there
  bool company = false;  // crushed, or another body that its own shape would strike
  bool touched = false;  // by anything, the room too: it may be kept from its own shape for good
};

/// Puts a body into its rest shape where it is, and says so; called after ticks of h s, once every `ticks`.
/// Unfolds one that for most of a second was much smaller or larger than in `equilibrium` (3n, m), or quiet
/// and untouched in another shape. It also unfolds one that had more than a thousandth of its volume inside
/// out or flat for so long. A body without any volume, or with three times its own, waits less; a crumpled
/// sheet or rope longer. In company it unfolds only what is ruined beyond what a press does or blind, and
/// what is of another volume only while nothing crushes it. What is jammed stays so until the hand leaves,
/// unless it has three times its volume. Returns true when it did.
bool unfold_if_tangled(SoftMember& member, const Surroundings& about, const VecX& equilibrium, double h,
                       int ticks);

}  // namespace prosector
