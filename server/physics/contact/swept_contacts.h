#pragma once
// Contacts of what is fast: where a rigid and a soft body would pass through each other within the tick.

#include <vector>

#include "server/physics/contact/surface_detector.h"
#include "server/physics/tissue.h"

namespace prosector {

/// Returns whether the two are met at their time of impact within h s rather than where they are now.
bool is_swept(const Tissue& tissue, const Collider& collider, double h);

/// Appends contacts as add_contacts() does; but where nothing touches yet, those that will when the collider
/// first comes near within h s. Velocities are taken as constant, the soft body's as that of its middle.
bool add_swept_contacts(const Tissue& tissue, const Collider& collider, double margin, double h,
                        std::vector<Contact>& out);

}  // namespace prosector
