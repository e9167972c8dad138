#pragma once
// Contacts of two soft bodies with mesh surfaces, and of a solid with itself.

#include <vector>

#include "server/physics/mechanics/contact/soft_meeting.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Returns the stiffness (N/m) of a contact of a vertex of body a with body b. Both surfaces yield: the
/// result is twice that of two springs in series. For equal bodies it is the stiffness against a rigid body.
double pair_stiffness(const Tissue& a, const Tissue& b, std::uint32_t vertex_of_a);

/// Returns a contact of the soft bodies a and b with the properties that all kinds of such contacts share.
/// Its sides have no nodes yet. `gap` is in m; `normal` is a unit vector.
contact::Contact pair_contact(const Tissue& a, const Tissue& b, const Vec3& normal, double gap);

/// Returns the contact of a vertex of body a with a face of body b, with the data that body a stored for it
/// in the last tick.
contact::Contact pair_contact(const Tissue& a, const Tissue& b, const contact::VertexMeeting& meeting);

/// Appends contacts of vertices of each body with faces of the other within `margin` (m) to `out`. `meetings`
/// is a buffer. Returns whether some vertices are so deep inside that the bodies must be separated as
/// described in parting.h.
bool add_vertex_contacts(Tissue& a, Tissue& b, double margin, std::vector<contact::VertexMeeting>& meetings,
                         std::vector<contact::Contact>& out);

/// Appends a solid's contacts with itself within `margin` (m) to `out`, for a tick of h s. `meetings` is a
/// buffer.
void add_self_contacts(Tissue& tissue, double margin, double h, std::vector<contact::VertexMeeting>& meetings,
                       std::vector<contact::Contact>& out);

}  // namespace prosector
