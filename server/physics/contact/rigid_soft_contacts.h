#pragma once
// Contacts of one soft body with one rigid thing.

#include <vector>

#include "server/physics/contact/surface_detector.h"
#include "server/physics/tissue.h"

namespace prosector {

/// Stretch of the surface at which a moving thing loses hold of it. Real tissue would have torn long before,
/// and what a leaping hand has hooked would never come free.
inline constexpr double most_stretch = 3;
inline constexpr double lip = 0.1;  // surface cells: what an edge runs over

/// Returns whether the two touch at all.
bool may_meet(const Tissue& tissue, const Collider& collider);

/// Appends what of the body's surface is within `margin` (m) of the collider, with what `held` remembers of
/// it. Returns whether there was any. `h`: s, the time that the contacts are for.
bool add_contacts(const Tissue& tissue, const Collider& collider, double margin, const ContactMemories& held,
                  double h, std::vector<Contact>& out);

/// Returns whether anything of the body's surface is within `margin` (m) of the collider.
bool touches(const Tissue& tissue, const Collider& collider, double margin);

/// Returns what all kinds of contact with a collider have in common; its soft side has no nodes yet.
Contact rigid_contact(const Tissue& tissue, const Vec3& point, const Distance& distance,
                      const Collider& collider);

/// Returns where the tick takes a kinematic collider's point, m from where it is.
Vec3 kinematic_way(const Collider& collider, const Vec3& point);

}  // namespace prosector
