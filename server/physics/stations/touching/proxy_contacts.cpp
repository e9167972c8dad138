#include "server/physics/stations/touching/proxy_contacts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "server/physics/mechanics/collision/outlines/rigid_outline.h"
#include "server/physics/mechanics/contact/shape_touch.h"
#include "server/physics/mechanics/rigid/rolling.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"
#include "server/physics/stations/touching/soft_pair_contacts.h"

namespace prosector {
namespace {

constexpr double sides = 6;  // of a box around a body: contacts on one side share a sixth of the surface area

/// Returns the total stiffness of contacts on one side of the shape, N/m: that of the body as a whole, times
/// the scene's factor.
double proxy_stiffness(const Tissue& tissue) {
  const auto areas = tissue.solver->surface_area();
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0) / sides;
  return tissue.collision.stiffness_factor * tissue.desc().material.youngs_modulus * std::sqrt(area);
}

/// Returns the body's rolling parameters; boxes don't roll.
rigid::RollingSide rolling_side(const Tissue& tissue) {
  if (!rolls(tissue.collision.fidelity)) return {};
  const contact::ProxyShape& shape = *tissue.surface.proxy();
  return {tissue.desc().contact.rolling_resistance, (shape.box().lo + shape.box().hi) / 2,
          shape.shape_matching().spin(tissue.state.motion.v)};
}

/// Appends contacts of two proxies.
void add_two_proxies(const Tissue& a, const Tissue& b, double margin, std::vector<contact::Contact>& out) {
  const contact::ProxyShape &shape_a = *a.surface.proxy(), &shape_b = *b.surface.proxy();
  std::vector<contact::ShapeTouch> touches;
  contact::find_touches(shape_a.piece(), shape_b.piece(), margin, touches);
  const contact::ShapeMatching &of_a = shape_a.shape_matching(), &of_b = shape_b.shape_matching();
  const std::size_t shares = std::max(of_a.shares(), of_b.shares());
  const double own = proxy_stiffness(a), other = proxy_stiffness(b);
  const rigid::RollingSide rolling_a = rolling_side(a), rolling_b = rolling_side(b);
  for (const contact::ShapeTouch& touch : touches) {
    const Vec3 at = touch.point + rigid::rolling_lead(rolling_a, rolling_b, touch.point, touch.normal);
    for (std::size_t share = 0; share < shares; ++share) {
      contact::Contact& c = out.emplace_back(pair_contact(a, b, touch.normal, touch.gap));
      c.point = of_a.hang(at, touch.normal, share % of_a.shares(), c.a);
      of_b.hang(at, touch.normal, share % of_b.shares(), c.b);
      c.stiffness = 2 * own * other / (own + other) / static_cast<double>(touches.size() * shares);
    }
  }
}

/// Appends contacts of the vertices of `a`, which has no proxy, with the proxy of `b`.
void add_vertices_and_proxy(const Tissue& a, const Tissue& b, double margin,
                            std::vector<contact::Contact>& out) {
  const contact::ProxyShape& shape = *b.surface.proxy();
  const double skin = a.half_thickness();
  const collision::Aabb reach = shape.box().grown(margin + skin);
  const contact::SurfaceDetector& vertices = a.surface.vertices();
  vertices.in_box(reach.lo, reach.hi, [&](std::uint32_t vertex) {
    const Vec3& x = vertices.positions()[vertex];
    const auto near = collision::proximity(collision::CollisionPiece(collision::SphereShape{x, skin}),
                                           shape.piece(), margin);
    if (!near) return;
    contact::Contact& c = out.emplace_back(pair_contact(a, b, near->normal, near->gap));
    c.a = a.side(vertex);
    c.point = x;
    shape.shape_matching().hang(x, near->normal, vertex % shape.shape_matching().shares(), c.b);
    c.stiffness = pair_stiffness(a, b, vertex);
    c.feature = vertex;
    contact::recall(contact::find(a.memories, c.b, c.feature), c);
  });
}

}  // namespace

bool add_proxy_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                        std::vector<contact::Contact>& out) {
  const contact::ProxyShape& own = *tissue.surface.proxy();
  if (!own.box().grown(margin).overlaps({collider.lo, collider.hi}) || !collider.outline) return false;
  std::vector<collision::CollisionPiece> pieces;
  collider.outline->place(collider.pose, collider.part_poses, pieces);
  std::vector<contact::ShapeTouch> touches;
  for (const collision::CollisionPiece& piece : pieces)
    if (own.box().grown(margin).overlaps(collision::box_of(piece)))
      contact::find_touches(own.piece(), piece, margin, touches);
  const std::size_t shares = own.shape_matching().shares();
  const double stiffness = proxy_stiffness(tissue) / static_cast<double>(touches.size() * shares);
  if (touches.empty()) return false;
  const rigid::RollingSide rolling = rolling_side(tissue);
  const rigid::RollingSide other{collider.rolling_resistance, collider.pose.p, collider.angular};
  for (const contact::ShapeTouch& touch : touches) {
    const Vec3 at = touch.point + rigid::rolling_lead(rolling, other, touch.point, touch.normal);
    for (std::size_t share = 0; share < shares; ++share) {
      contact::Contact c = rigid_contact(tissue, touch.point, {touch.gap, touch.normal}, collider);
      c.point = own.shape_matching().hang(at, touch.normal, share, c.a);
      if (!collider.fixed) c.b.arm = c.point - collider.pose.p;
      c.stiffness = stiffness;
      out.push_back(c);
    }
  }
  return true;
}

bool add_proxy_pair_contacts(const Tissue& a, const Tissue& b, double margin,
                             std::vector<contact::Contact>& out) {
  if (!b.surface.proxy()) return add_proxy_pair_contacts(b, a, margin, out);
  const std::size_t before = out.size();
  if (a.surface.proxy())
    add_two_proxies(a, b, margin, out);
  else
    add_vertices_and_proxy(a, b, margin, out);
  return out.size() > before;
}

}  // namespace prosector
