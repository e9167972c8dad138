#pragma once
// Contacts of fast bodies: prevents a rigid and a soft body from passing through each other within a tick.

#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Returns whether contacts of the two are found at their time of impact within h s, instead of at the
/// current pose.
bool is_swept(const Tissue& tissue, const Collider& collider, double h);

/// Appends contacts like add_contacts() if the two already touch. Otherwise appends the contacts of the first
/// time within h s at which the collider is near. Velocities are constant; the soft body moves with its mean
/// velocity.
bool add_swept_contacts(const Tissue& tissue, const Collider& collider, double margin, double h,
                        std::vector<Contact>& out);

}  // namespace prosector
