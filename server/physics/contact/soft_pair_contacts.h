#pragma once
// Contacts of two soft bodies whose surfaces are meshes, and of a solid with itself.

#include <vector>

#include "server/physics/contact/soft_meeting.h"
#include "server/physics/tissue.h"

namespace prosector {

/// Returns the stiffness of a contact of a's vertex with b, N/m. Both surfaces give way, each as its own
/// tissue would: twice two springs in series, so that of two equal bodies each counts as against something
/// rigid.
double pair_stiffness(const Tissue& a, const Tissue& b, std::uint32_t vertex_of_a);

/// Returns what all contacts of the two have in common; the sides are yet to be filled in.
Contact pair_contact(const Tissue& a, const Tissue& b, const Vec3& normal, double gap);

/// Returns the contact of a's vertex with b's face, with what a remembers of it.
Contact pair_contact(const Tissue& a, const Tissue& b, const VertexMeeting& meeting);

/// Appends where vertices of one come within `margin` (m) of faces of the other. `meetings` is what finding
/// them works in. Returns whether some are deep, so that parting.h has to look.
bool add_vertex_contacts(Tissue& a, Tissue& b, double margin, std::vector<VertexMeeting>& meetings,
                         std::vector<Contact>& out);

/// Appends where a solid comes within `margin` (m) of itself, for a tick of h s.
void add_self_contacts(Tissue& tissue, double margin, double h, std::vector<VertexMeeting>& meetings,
                       std::vector<Contact>& out);

}  // namespace prosector
