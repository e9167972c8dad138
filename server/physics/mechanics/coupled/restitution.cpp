#include "server/physics/mechanics/coupled/restitution.h"

#include <Eigen/LU>
#include <algorithm>

#include "common/assert.h"

namespace prosector::coupled {
namespace {

constexpr double least_approach = 0.2;  // m/s, as in Bullet: slower impacts have no restitution
constexpr double overlap = 1e-3;        // m: deeper than gravity causes
constexpr int sweeps = 20;

struct Body {
  Vec3 v, w;  // m/s, rad/s
  double inverse_mass;
  Mat3 inverse_inertia;
};

/// One side of an impact; no body: fixed.
struct Side {
  Body* body;
  const contact::ContactSide* at;
};

struct Impact {
  contact::Contact* contact;
  Side a, b;
  double mobility = 0;  // 1/kg, along the normal
  double least = 0;     // N·s: most negative impulse; an overlap's push may be taken back
  double impulse = 0;   // N·s
};

Vec3 velocity(const Side& side, double h) {
  if (!side.body) return side.at->moved / h;
  return side.body->v + side.body->w.cross(side.at->arm);
}

double mobility(const Side& side, const Vec3& n) {
  if (!side.body) return 0;
  const Vec3 lever = side.at->arm.cross(n);
  return side.body->inverse_mass + lever.dot(side.body->inverse_inertia * lever);
}

void push(const Side& side, const Vec3& impulse) {
  if (!side.body) return;
  side.body->v += side.body->inverse_mass * impulse;
  side.body->w += side.body->inverse_inertia * side.at->arm.cross(impulse);
}

}  // namespace

double rebound_speed(double restitution, double approach) {
  return approach < -least_approach ? -restitution * approach : 0;
}

bool bounce(Island& island, double h) {
  PROSECTOR_ASSERT(h > 0);
  const auto presses = [](const contact::Contact& c) {
    return c.a.kind != contact::ContactSide::Kind::soft && c.force > 0;
  };
  if (std::none_of(island.contacts.begin(), island.contacts.end(), [&](const contact::Contact& c) {
        return presses(c) && (c.rebound > 0 || c.gap < -overlap);
      }))
    return false;
  std::vector<Body> bodies;
  for (const RigidMember& m : island.rigid)
    bodies.push_back({m.twist.head<3>() / h, m.twist.tail<3>() / h, 1 / m.mass, m.inertia.inverse()});
  const auto resolve = [&](const contact::ContactSide& side) -> Side {
    if (side.kind != contact::ContactSide::Kind::rigid) return {nullptr, &side};
    std::size_t m = 0;
    while (island.rigid[m].slot != side.body) ++m;
    return {&bodies[m], &side};
  };
  std::vector<Impact> impacts;
  for (contact::Contact& c : island.contacts) {
    if (!presses(c)) continue;
    Impact& impact = impacts.emplace_back(Impact{&c, resolve(c.a), resolve(c.b)});
    impact.mobility = mobility(impact.a, c.normal) + mobility(impact.b, c.normal);
    if (c.gap < -overlap) impact.least = -h * c.force;
  }
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (Impact& impact : impacts) {
      const Vec3& n = impact.contact->normal;
      if (!(impact.mobility > 0)) continue;
      const double parting = n.dot(velocity(impact.a, h) - velocity(impact.b, h));
      const double total =
          std::max(impact.least, impact.impulse + (impact.contact->rebound - parting) / impact.mobility);
      push(impact.a, (total - impact.impulse) * n);
      push(impact.b, (impact.impulse - total) * n);
      impact.impulse = total;
    }
  for (const Impact& impact : impacts) {
    impact.contact->force += impact.impulse / h;
    impact.contact->exchanged += impact.impulse / h * impact.contact->normal;
  }
  for (std::size_t m = 0; m < bodies.size(); ++m) island.rigid[m].twist << h * bodies[m].v, h * bodies[m].w;
  return true;
}

}  // namespace prosector::coupled
