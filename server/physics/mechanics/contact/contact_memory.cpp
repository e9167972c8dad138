#include "server/physics/mechanics/contact/contact_memory.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace prosector::contact {
namespace {

constexpr double rest_time = 0.15;  // s: time constant with which rest gaps rise to 0
constexpr double same_side = 0.7;   // cosine between normals on the same side of a layer

using Key = std::tuple<bool, std::size_t, std::uint32_t, std::uint32_t>;

Key key(const ContactMemory& m) {
  return {m.soft, m.body, m.feature, m.met};
}

Key key(const ContactSide& other, std::uint32_t feature, std::uint32_t met = 0) {
  return {other.kind == ContactSide::Kind::soft, other.body, feature, met};
}

ContactMemories::const_iterator first_from(const ContactMemories& memories, const Key& wanted) {
  return std::lower_bound(memories.begin(), memories.end(), wanted,
                          [](const ContactMemory& m, const Key& k) { return key(m) < k; });
}

/// Returns the total force (N) of the last tick's contacts on faces with the other side that no longer exist.
double vanished(const ContactMemories& memories, const ContactSide& other, std::uint32_t first_face,
                std::span<const Contact> contacts) {
  double force = 0;
  for (auto m = first_from(memories, key(other, first_face)); m != memories.end(); ++m) {
    if (Key(m->soft, m->body, 0, 0) != key(other, 0)) break;
    const bool there = std::any_of(contacts.begin(), contacts.end(),
                                   [&](const Contact& c) { return c.feature == m->feature; });
    if (!there) force += m->force;
  }
  return force;
}

}  // namespace

const ContactMemory* find(const ContactMemories& memories, const ContactSide& other, std::uint32_t feature,
                          std::uint32_t met) {
  const Key wanted = key(other, feature, met);
  const auto at = first_from(memories, wanted);
  return at != memories.end() && key(*at) == wanted ? &*at : nullptr;
}

const ContactMemory* find_layer(const ContactMemories& memories, const Contact& contact) {
  if (const ContactMemory* same = find(memories, contact.b, contact.feature, contact.met)) return same;
  const ContactMemory* best = nullptr;
  const Key first = key(contact.b, contact.feature);
  for (auto m = first_from(memories, first); m != memories.end(); ++m) {
    if (Key(m->soft, m->body, m->feature, 0) != first) break;
    if (m->normal.dot(contact.normal) > same_side && (!best || m->force > best->force)) best = &*m;
  }
  return best;
}

void recall(const ContactMemory* memory, Contact& contact) {
  if (!memory) return;
  contact.grip = memory->grip;
  contact.gripped = memory->force;
}

void rest(const ContactMemories& memories, std::uint32_t first_face, double h, std::span<Contact> contacts) {
  if (contacts.empty()) return;
  double to_inherit = vanished(memories, contacts.front().b, first_face, contacts);
  for (Contact& c : contacts) {
    const double gap = std::min(c.gap, 0.0);
    if (c.feature < first_face || gap == 0) continue;
    if (const ContactMemory* m = find(memories, c.b, c.feature)) {
      c.rest = std::max(m->rest * std::exp(-h / rest_time), gap);
      if (c.stiffness > m->stiffness) c.rest += (gap - c.rest) * (1 - m->stiffness / c.stiffness);
    } else {
      const double force = std::min(to_inherit, -c.stiffness * gap);
      to_inherit -= force;
      // Never below -gap * stiffness in exact arithmetic, but the quotient is rounded.
      c.rest = std::min(gap + force / c.stiffness, 0.0);
    }
    c.gap -= c.rest;
  }
}

bool is_consistent(const ContactMemory& m) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  return positive(m.force) && positive(m.stiffness) && m.rest <= 0 && std::isfinite(m.rest) &&
         m.grip.allFinite() && m.normal.allFinite();
}

void keep(std::span<const Contact> contacts, std::size_t body, ContactMemories& memories) {
  memories.clear();
  for (const Contact& c : contacts) {
    if (c.a.kind != ContactSide::Kind::soft || c.a.body != body || c.feature == Contact::no_feature) continue;
    const ContactMemory m = {c.b.kind == ContactSide::Kind::soft,
                             c.b.body,
                             c.feature,
                             c.met,
                             c.grip_after,
                             c.force,
                             c.normal,
                             c.stiffness,
                             c.rest};
    if (is_consistent(m)) memories.push_back(m);
  }
  std::sort(memories.begin(), memories.end(),
            [](const ContactMemory& a, const ContactMemory& b) { return key(a) < key(b); });
}

}  // namespace prosector::contact
