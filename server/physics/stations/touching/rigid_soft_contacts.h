#pragma once
// Contacts of one soft body with one rigid collider.

#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Stretch of the surface above which contacts with a moving collider are released. Real tissue would have
/// torn long before, and tissue caught on a hand that jumped would never come free.
inline constexpr double most_stretch = 3;
inline constexpr double lip = 0.1;  // surface cells: overlap up to which an edge only grazes a vertex

/// Returns whether the two can collide.
bool may_meet(const Tissue& tissue, const Collider& collider);

/// Appends contacts of the body's surface within `margin` (m) of the collider, with their memories from
/// `held`. Returns whether there was any. `h`: s, duration of the contacts.
bool add_contacts(const Tissue& tissue, const Collider& collider, double margin, const ContactMemories& held,
                  double h, std::vector<Contact>& out);

/// Returns whether anything of the body's surface is within `margin` (m) of the collider.
bool touches(const Tissue& tissue, const Collider& collider, double margin);

/// Returns a contact with the properties common to all kinds of contact with a collider; its soft side has no
/// nodes yet.
Contact rigid_contact(const Tissue& tissue, const Vec3& point, const Distance& distance,
                      const Collider& collider);

/// Returns the displacement of a kinematic collider's point in the tick, m.
Vec3 kinematic_way(const Collider& collider, const Vec3& point);

}  // namespace prosector
