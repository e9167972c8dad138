#pragma once
// Contacts that integrate the pressure over where a soft surface touches a rigid thing.
//
// Each stands for a part of the surface's area. Its force goes to all nodes of the element by the element's
// functions. Within that part the gap varies, the more the farther the two are from parallel (EvenSpring). So
// the force is as smooth as the area that touches.

#include <vector>

#include "server/physics/contact/memory.h"
#include "server/physics/contact/surface_detector.h"
#include "server/physics/tissue.h"

namespace prosector {

/// Returns how many features such contacts of a surface may have.
std::uint32_t area_features(const TriangleMesh& surface);

/// Appends the points of the body's surface that are within `margin` (m) of the collider, with what `held`
/// remembers of them. A vertex' feature is its number, a face point's all vertices' count, plus
/// most_face_points times its triangle, plus its own number. What such a point presses beyond the depth of a
/// dent is a contact of its own: its feature comes after all those.
void add_area_contacts(const Tissue& tissue, const Collider& collider, double margin,
                       const ContactMemories& held, std::vector<Contact>& out);

}  // namespace prosector
