#pragma once
// Contacts of soft bodies that collide as a proxy shape: sphere, box or hull.

#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Appends contacts of the soft body's proxy shape (sphere, box or hull) with the collider's outline, within
/// `margin` (m), to `out`. Returns whether there was any.
bool add_proxy_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                        std::vector<contact::Contact>& out);

/// Appends contacts within `margin` (m) of two soft bodies, of which at least one collides as a proxy shape
/// (sphere, box or hull), to `out`. Returns whether there was any.
bool add_proxy_pair_contacts(const Tissue& a, const Tissue& b, double margin,
                             std::vector<contact::Contact>& out);

}  // namespace prosector
