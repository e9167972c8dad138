#pragma once
// Contacts of two soft bodies with mesh surfaces, and of a solid with itself.

#include <vector>

#include "server/physics/mechanics/contact/soft_meeting.h"
#include "server/physics/world/tissue.h"

namespace prosector {

/// Returns the stiffness of a contact of a's vertex with b, N/m. Both surfaces yield: the result is twice two
/// springs in series. For equal bodies it is the stiffness against a rigid body.
double pair_stiffness(const Tissue& a, const Tissue& b, std::uint32_t vertex_of_a);

/// Returns a contact with the properties common to all contacts of the two; its sides have no nodes yet.
Contact pair_contact(const Tissue& a, const Tissue& b, const Vec3& normal, double gap);

/// Returns the contact of a's vertex with b's face, with its memory in a.
Contact pair_contact(const Tissue& a, const Tissue& b, const VertexMeeting& meeting);

/// Appends contacts of vertices of one body with faces of the other within `margin` (m). `meetings` is a
/// buffer. Returns whether some are deep, so that parting.h must be used.
bool add_vertex_contacts(Tissue& a, Tissue& b, double margin, std::vector<VertexMeeting>& meetings,
                         std::vector<Contact>& out);

/// Appends a solid's contacts with itself within `margin` (m), for a tick of h s.
void add_self_contacts(Tissue& tissue, double margin, double h, std::vector<VertexMeeting>& meetings,
                       std::vector<Contact>& out);

}  // namespace prosector
