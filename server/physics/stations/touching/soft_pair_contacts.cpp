#include "server/physics/stations/touching/soft_pair_contacts.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/contact/parting.h"
#include "server/physics/stations/touching/thin_shell_contacts.h"

namespace prosector {
namespace {

// Largest pressure of an overlap, times the softer body's Young's modulus. So bodies that overlap in the
// scene, or collided too fast, separate slowly.
constexpr double most_pressure = 4;

}  // namespace

double pair_stiffness(const Tissue& a, const Tissue& b, std::uint32_t vertex) {
  const SoftDesc &of_a = a.desc(), &of_b = b.desc();
  const double own = a.contact_stiffness(vertex);
  const double ratio = of_b.material.youngs_modulus / of_b.geometry.surface_cell /
                       (of_a.material.youngs_modulus / of_a.geometry.surface_cell);
  return 2 * own * ratio / (1 + ratio);
}

contact::Contact pair_contact(const Tissue& a, const Tissue& b, const Vec3& normal, double gap) {
  const SoftDesc &of_a = a.desc(), &of_b = b.desc();
  contact::Contact c;
  c.a.kind = c.b.kind = contact::ContactSide::Kind::soft;
  c.a.body = a.index;
  c.b.body = b.index;
  c.normal = normal;
  const double cell = std::min(of_a.geometry.surface_cell, of_b.geometry.surface_cell);
  c.gap = std::max(gap, -most_pressure * cell / a.collision.stiffness_factor);
  c.friction = std::sqrt(of_a.contact.friction * of_b.contact.friction);
  return c;
}

contact::Contact pair_contact(const Tissue& a, const Tissue& b, const contact::VertexMeeting& meeting) {
  const Anatomy& other = b.anatomy();
  contact::Contact c = pair_contact(a, b, meeting.normal, meeting.gap);
  c.a = a.side(meeting.vertex);
  const auto& corners = other.surface.triangles[meeting.at.triangle];
  for (std::size_t k = 0; k < 3; ++k)
    c.b.add(other.embedding.rows[corners[k]], meeting.at.weights[static_cast<Eigen::Index>(k)]);
  c.feature = meeting.vertex;
  c.point = a.surface.vertices().positions()[meeting.vertex];
  c.stiffness = pair_stiffness(a, b, meeting.vertex);
  contact::recall(contact::find(a.memories, c.b, c.feature), c);
  return c;
}

bool add_vertex_contacts(Tissue& a, Tissue& b, double margin, std::vector<contact::VertexMeeting>& meetings,
                         std::vector<contact::Contact>& out) {
  const contact::SoftSkin first = a.skin(), second = b.skin();
  bool deep = false;
  const auto add = [&](const Tissue& from, const Tissue& to, const contact::SoftSkin& own,
                       const contact::SoftSkin& other) {
    meetings.clear();
    contact::find_meetings(own, other, margin, meetings);
    deep = deep || contact::may_be_immersed(own, other, meetings);
    for (const contact::VertexMeeting& meeting : meetings) out.push_back(pair_contact(from, to, meeting));
  };
  add(a, b, first, second);
  add(b, a, second, first);
  return deep;
}

void add_self_contacts(Tissue& tissue, double margin, double h, std::vector<contact::VertexMeeting>& meetings,
                       std::vector<contact::Contact>& out) {
  meetings.clear();
  tissue.surface.self_collision()->find(tissue.skin(), margin, meetings);
  for (const contact::VertexMeeting& meeting : meetings) {
    contact::Contact c = pair_contact(tissue, tissue, meeting);
    c.gap = std::max(c.gap, -overlap_opening_speed * h);
    out.push_back(c);
  }
}

}  // namespace prosector
