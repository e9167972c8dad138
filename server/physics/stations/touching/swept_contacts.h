#pragma once
// Contacts of fast bodies: prevents a rigid and a soft body from passing through each other within a tick.

#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Returns whether contacts of the soft body and the collider are found at their time of impact within h s,
/// because they move fast, instead of at the current pose.
bool is_swept(const Tissue& tissue, const contact::Collider& collider, double h);

/// Appends contacts of a soft body with a fast collider to `out`. If both already touch, the contacts are
/// those at the current poses within `margin` (m). Otherwise they are those at the first time within h s at
/// which the collider is near the body. Velocities count as constant, and the soft body moves with its mean
/// velocity. Returns whether there was any.
bool add_swept_contacts(const Tissue& tissue, const contact::Collider& collider, double margin, double h,
                        std::vector<contact::Contact>& out);

}  // namespace prosector
