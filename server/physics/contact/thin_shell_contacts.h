#pragma once
// Contacts of sheets and ropes with each other and with themselves.

#include <vector>

#include "server/physics/contact/layers.h"
#include "server/physics/tissue.h"

namespace prosector {

// m/s, at which what overlaps when the tick starts is parted: so no overlap gives more energy than that.
inline constexpr double overlap_opening_speed = 0.06;

/// Appends where elements of the two come within `margin` (m) of each other and may meet within h s. `sides`
/// tells, and learns, on which side of each other they are; `one_organ`: they were one body, as a body is
/// with itself. Returns how many pairs of elements are through each other.
int add_thin_shell_contacts(Tissue& a, Tissue& b, std::vector<LayerSide>& sides, bool one_organ,
                            double margin, double h, std::vector<Contact>& out);

}  // namespace prosector
