#include "server/physics/stations/touching/parting_contacts.h"

#include <algorithm>

#include "server/physics/stations/touching/soft_pair_contacts.h"

namespace prosector {
namespace {

// Bodies too deep in each other are separated as wholes with small forces, which deform tissue little.
constexpr double parting_speed = 0.25;    // m/s
constexpr double parting_pressure = 0.5;  // times the softer body's Young's modulus

}  // namespace

std::optional<contact::Entanglement> add_parting_contacts(Tissue& a, Tissue& b,
                                                          const contact::Entanglement* before, bool pressed,
                                                          double h, std::size_t first_contact,
                                                          std::vector<contact::Contact>& out) {
  const contact::SoftSkin first = a.skin(), second = b.skin();
  const contact::Immersion of_a = contact::find_immersion(first, second, a.inside_out(), b.inside_out());
  const contact::Immersion of_b = contact::find_immersion(second, first, b.inside_out(), a.inside_out());
  const double cell = std::min(first.cell, second.cell), step = parting_speed * h;
  const std::optional<contact::Entanglement> now =
      contact::lead_apart(of_a, of_b, a.middle() - b.middle(), before, pressed, cell, h);
  if (!now) return now;
  if (now->whole) out.resize(first_contact);
  std::vector<contact::Contact> led;
  const auto lead = [&](const Tissue& from, const Tissue& to, const contact::Immersion& inside,
                        const Vec3& along) {
    for (const contact::VertexMeeting& meeting : inside.vertices) {
      if (!now->whole && !contact::came_through(meeting, along, cell)) continue;
      std::erase_if(out, [&](const contact::Contact& c) {
        return c.a.body == from.index && c.b.body == to.index && c.feature == meeting.vertex &&
               c.a.kind == contact::ContactSide::Kind::soft && c.b.kind == contact::ContactSide::Kind::soft;
      });
      contact::Contact& c = led.emplace_back(pair_contact(from, to, meeting));
      c.normal = along;
      c.gap = -step;
      c.friction = 0;
      c.feature = contact::Contact::no_feature;
      c.grip.setZero();
      c.gripped = 0;
      c.stiffness *= parting_pressure * cell / a.collision.stiffness_factor / step;
    }
  };
  lead(a, b, of_a, now->way);
  lead(b, a, of_b, -now->way);
  out.insert(out.end(), led.begin(), led.end());
  return now;
}

}  // namespace prosector
