#pragma once
// Recovery from degenerate shapes.
//
// Most laws have minima besides the rest shape. A mirrored body under St. Venant-Kirchhoff's law stores no
// energy, a neo-Hookean body that collapsed to a point stays there, and springs do not distinguish inside
// from outside. No such minimum of the corotational law was ever found. So a body with inverted or flat
// elements is stepped with that law and the same constants until it has recovered. A body under fem_linear
// that has rotated as a whole is stepped with it too, because fem_linear treats every rotation as strain.
//
// A body that still comes to rest in a wrong shape is unfolded: a reset. So is a body at rest that a law for
// small rotations treats as rotated, since it is longer than it should be.

#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Decides before a tick of h s whether the soft body is stepped under its own material law or under the
/// recovery law (corotational). The recovery law is used while elements are inverted or flat, or while the
/// rotation is too large for a linear law. Sets SoftBodyState::recovering and the member's note. A switch
/// clears the history of multi-step integrators.
void choose_law(SoftMember& member, double h);

/// Returns whether a soft body that moves slowly may fall asleep. It may not while it is tangled or while
/// more than a thousandth of its volume is inverted or flat. Nor may it while it is about to return from the
/// recovery law to its own material law.
bool may_sleep(const SoftMember& member);

/// Number of consecutive ticks with all node speeds below 1 mm/s after which a soft body may sleep.
/// count_quiet_ticks() updates the body's count after each tick.
inline constexpr int quiet_ticks_to_sleep = 30;
void count_quiet_ticks(SoftMember& member);

/// Surroundings of a tangled soft body, on which it depends whether the body may be reset to its rest shape:
/// whether it is squeezed, near other bodies or touched.
struct Surroundings {
  bool jammed = false;   // between a hand, or tissue in a hand, and other tissue
  bool crushed = false;  // jammed, in a hand, or between rigid bodies: may have another volume permanently
  bool blind = false;    // deep in tissue from which it can't be separated, because tissue there is inverted
  bool company = false;  // crushed, or near another body that its rest shape would hit
  bool touched = false;  // by anything, including the room: may be kept from its rest shape permanently
};

/// Unfolds a soft body that stayed tangled: resets it to its rest shape at its current position, and reports
/// that in its note. Returns whether it did. Called after ticks of h s, once every `ticks`. `about`: the
/// body's surroundings; `equilibrium`: node positions (3n, m) at rest under gravity.
///
/// A body is unfolded after 0.75 s with more than a thousandth of its volume inverted or flat, or with a much
/// smaller or larger volume than in equilibrium. So is a body that is quiet and untouched in another shape
/// than its equilibrium. With no volume, or three times its volume, it is unfolded after 0.1 s. A crumpled
/// sheet or rope that still moves is unfolded after 4 s.
///
/// In company (`about.company`), a body is unfolded only if more of it is inverted than a press can explain,
/// or if it is blind. A crushed body is not unfolded for its volume. A jammed body is left alone until the
/// hand leaves, unless it has three times its volume.
bool unfold_if_tangled(SoftMember& member, const Surroundings& about, const VecX& equilibrium, double h,
                       int ticks);

}  // namespace prosector::coupled
