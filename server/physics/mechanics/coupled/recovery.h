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

namespace prosector {

/// Chooses the law for the body's tick of h s (SoftBodyState::recovering), before the tick, and reports it in
/// the member. A switch clears the multi-step history.
void choose_law(SoftMember& member, double h);

/// Returns whether a quiet body may sleep: neither tangled nor inverted, and not about to leave recovery.
bool may_sleep(const SoftMember& member);

/// Number of quiet ticks before a body may sleep. count_quiet_ticks() updates its count after each tick.
inline constexpr int quiet_ticks_to_sleep = 30;
void count_quiet_ticks(SoftMember& member);

/// The surroundings of a body that may be unfolded.
struct Surroundings {
  bool jammed = false;   // between a hand, or tissue in a hand, and other tissue
  bool crushed = false;  // jammed, in a hand, or between rigid bodies: may have another volume permanently
  bool blind = false;    // deep in tissue from which it can't be separated, because tissue there is inverted
  bool company = false;  // crushed, or near another body that its rest shape would hit
  bool touched = false;  // by anything, including the room: may be kept from its rest shape permanently
};

/// Unfolds a tangled body: puts it into its rest shape at its current position, and sets its note. Called
/// after ticks of h s, once every `ticks`. Returns whether the body was unfolded. Unfolds a body that for
/// most of a second
///   had a much smaller or larger volume than in `equilibrium` (3n, m),
///   had more than a thousandth of its volume inverted or flat,
///   or was quiet and untouched in another shape.
///
/// A body with zero volume, or three times its volume, is unfolded sooner; a crumpled sheet or rope later. A
/// body in company is unfolded only if more of it is inverted than a press can explain, or if it is blind. A
/// crushed body is not unfolded for its volume. A jammed body is left alone until the hand leaves, unless it
/// has three times its volume.
bool unfold_if_tangled(SoftMember& member, const Surroundings& about, const VecX& equilibrium, double h,
                       int ticks);

}  // namespace prosector
