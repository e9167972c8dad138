#pragma once
// Contacts of sheets and ropes with each other and with themselves.

#include <vector>

#include "server/physics/mechanics/contact/layers.h"
#include "server/physics/world/tissue.h"

namespace prosector {

// m/s: separation speed of overlaps at the tick's start, which limits their energy gain.
inline constexpr double overlap_opening_speed = 0.06;

/// Appends contacts of the elements of two sheets or ropes within `margin` (m) that may touch within h s to
/// `out`. `sides` are the known sides of element pairs, which are updated. `one_organ`: whether both were cut
/// from one original body, or are the same body. Returns the number of element pairs that have passed through
/// each other.
int add_thin_shell_contacts(Tissue& a, Tissue& b, std::vector<contact::LayerSide>& sides, bool one_organ,
                            double margin, double h, std::vector<contact::Contact>& out);

}  // namespace prosector
