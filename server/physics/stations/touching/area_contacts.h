#pragma once
// Contacts that integrate the pressure over the area where a soft surface touches a rigid body.
//
// Each contact represents a part of the surface's area. Its force is distributed to all nodes of the element
// by the element's shape functions. Within its area the gap varies, more the less parallel both surfaces are
// (EvenSpring). So the force is as smooth as the touching area.

#include <vector>

#include "server/physics/mechanics/contact/contact_memory.h"
#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Returns the number of feature indices of a surface that area contacts (points that integrate the pressure)
/// may use.
std::uint32_t area_features(const TriangleMesh& surface);

/// Appends contacts at the points of the body's surface within `margin` (m) of the collider to `out`. A
/// contact that existed in the last tick continues with its force and friction from `held`. A vertex' feature
/// (contact index) is its index. A face point's feature is the number of vertices plus most_face_points times
/// its triangle plus its own index. A point that may get deeper in a round collider than a dent
/// has a second contact, which adds pressure beyond that depth. The second contact's feature is larger by the
/// number of points.
void add_area_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                       const contact::ContactMemories& held, std::vector<contact::Contact>& out);

}  // namespace prosector
