#pragma once
// Contacts of one soft body with one rigid collider.

#include <vector>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Ratio of current to rest length of a soft surface above which its contacts with a moving collider are
/// released. Real tissue would have torn long before, and tissue caught on a hand that jumped would never
/// come free.
inline constexpr double most_stretch = 3;
inline constexpr double lip = 0.1;  // surface cells: overlap up to which an edge only grazes a vertex

/// Returns whether the soft body and the collider may collide. They may not if their collision groups exclude
/// it, the collider is a blade in a hand, or the soft body passes through that side of the room.
bool may_meet(const Tissue& tissue, const contact::Collider& collider);

/// Appends contacts of the soft body's surface within `margin` (m) of the collider to `out`. A contact that
/// existed in the last tick continues with its force and friction from `held`. Returns whether there was any.
/// `h` is the time for which the contacts are used, s.
bool add_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                  const contact::ContactMemories& held, double h, std::vector<contact::Contact>& out);

/// Returns whether any point of the soft body's surface is within `margin` (m) of the collider.
bool touches(const Tissue& tissue, const contact::Collider& collider, double margin);

/// Returns a contact of a soft body with a collider at `point` (m, world frame), with the properties that all
/// kinds of such contacts share. Its soft side has no nodes yet.
contact::Contact rigid_contact(const Tissue& tissue, const Vec3& point, const contact::Distance& distance,
                               const contact::Collider& collider);

/// Returns the displacement (m) in the tick of the point of a kinematic collider (on a prescribed trajectory)
/// that is now at `point`.
Vec3 kinematic_way(const contact::Collider& collider, const Vec3& point);

}  // namespace prosector
