#include "server/physics/stations/touching/rigid_soft_contacts.h"

#include <algorithm>

#include "server/physics/mechanics/contact/area_rule.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/mechanics/contact/vertex_gap.h"
#include "server/physics/stations/touching/area_contacts.h"
#include "server/physics/stations/touching/proxy_contacts.h"

namespace prosector {
namespace {

contact::Contact vertex_contact(const Tissue& tissue, std::uint32_t vertex, const contact::Distance& distance,
                                const contact::Collider& collider) {
  contact::Contact c =
      rigid_contact(tissue, tissue.surface.vertices().positions()[vertex], distance, collider);
  c.a.add(tissue.anatomy().embedding.rows[vertex], 1);
  c.stiffness = tissue.contact_stiffness(vertex);
  c.feature = vertex;
  return c;
}

contact::Contact face_contact(const Tissue& tissue, const contact::TriangleTouch& touch,
                              const contact::Collider& collider) {
  const Anatomy& anatomy = tissue.anatomy();
  const auto& corners = anatomy.surface.triangles[touch.triangle];
  contact::Contact c = rigid_contact(tissue, touch.point, {touch.gap, touch.normal}, collider);
  for (std::size_t k = 0; k < 3; ++k) {
    const double share = touch.weights[static_cast<Eigen::Index>(k)];
    c.a.add(anatomy.embedding.rows[corners[k]], share);
    c.stiffness += touch.strength * share * tissue.contact_stiffness(corners[k]);
  }
  return c;
}

/// First indices of contact features.
struct Features {
  explicit Features(const Tissue& tissue) {
    const TriangleMesh& surface = tissue.anatomy().surface;
    first_face = tissue.collision.over_area ? area_features(surface)
                                            : static_cast<std::uint32_t>(surface.positions.size());
    first_corner = first_face + static_cast<std::uint32_t>(surface.triangles.size());
  }
  std::uint32_t first_face, first_corner;
};

void add_vertex_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                         const contact::ContactMemories& held, std::vector<contact::Contact>& out) {
  const contact::SurfaceDetector& vertices = tissue.surface.vertices();
  const double skin = tissue.half_thickness();
  const bool still = collider.fixed && !collider.driven_to;
  contact::ContactSide other;
  other.body = collider.slot;
  vertices.near(collider, margin + skin, [&](std::uint32_t vertex, contact::Distance d) {
    const contact::ContactMemory* memory = contact::find(held, other, vertex);
    contact::Approach approach{vertices.positions()[vertex], d};
    if (memory) {
      approach.before = &memory->normal;
      approach.depth = memory->force / tissue.contact_stiffness(vertex);
    }
    if (skin == 0) approach.outward = vertices.outward_at(vertex);
    approach.lip = lip * tissue.desc().geometry.surface_cell;
    std::optional<contact::Distance> side = contact::side_of(collider, approach);
    if (!side) return;
    side->value -= skin;
    if (!still && vertices.stretch_at(vertex) >= most_stretch) return;
    contact::recall(memory, out.emplace_back(vertex_contact(tissue, vertex, *side, collider)));
  });
}

/// Adds contacts with parts that would slip between the regular contact points: thin parts and corners.
void add_between(const Tissue& tissue, const contact::Collider& collider, double margin,
                 const contact::ContactMemories& held, const Features& features,
                 std::vector<contact::Contact>& out) {
  const contact::SurfaceDetector& vertices = tissue.surface.vertices();
  const double skin = tissue.half_thickness();
  // Thin parts are round and boxes are flat; these are the regular contact points under each.
  std::span<const Vec3> under_round, under_flat;
  if (tissue.collision.over_area) under_round = contact::places_on_quarters();
  if (tissue.collision.over_area && tissue.desc().configuration.is_quadratic())
    under_flat = contact::places_on_quarters().last(1);
  contact::ContactSide other;
  other.body = collider.slot;
  const contact::KnownSide known = [&](std::uint32_t triangle) -> std::optional<Vec3> {
    if (const contact::ContactMemory* own = contact::find(held, other, features.first_face + triangle))
      return own->normal;
    for (const std::uint32_t next : vertices.neighbours(triangle))
      if (const contact::ContactMemory* near_it = contact::find(held, other, features.first_face + next))
        return near_it->normal;
    return std::nullopt;
  };
  // No friction memory for thin parts: a rolling part does not stay at a point of the face. Corners don't
  // roll.
  vertices.near_thin(collider, margin + skin, known, under_round, [&](contact::TriangleTouch touch) {
    touch.gap -= skin;
    out.push_back(face_contact(tissue, touch, collider));
    out.back().feature = features.first_face + touch.triangle;
  });
  if (skin > 0) return;
  contact::box_corners(collider, margin, vertices.lo(), vertices.hi(), [&](const contact::BoxCorner& corner) {
    const auto touch = vertices.near_corner(collider, corner.at, margin, corner.depth, under_flat);
    if (!touch) return;
    out.push_back(face_contact(tissue, *touch, collider));
    out.back().feature = features.first_corner + corner.index;
    contact::recall(contact::find(held, other, out.back().feature), out.back());
  });
}

}  // namespace

bool may_meet(const Tissue& tissue, const contact::Collider& collider) {
  const contact::SoftCollision& own = tissue.collision;
  if (rigid::is_room(collider.slot) && rigid::has_side(own.passes, rigid::room_side(collider.slot)))
    return false;
  return collider.parts && !collider.held_blade && own.fidelity != Fidelity::none &&
         collision::may_touch(own.mask, collider.mask);
}

Vec3 kinematic_way(const contact::Collider& collider, const Vec3& point) {
  if (!collider.driven_to) return Vec3::Zero();
  const Vec3 way = *collider.driven_to * (collider.pose.inverse() * point) - point;
  return way * std::min(1.0, contact::most_reach / std::max(way.norm(), contact::most_reach));
}

contact::Contact rigid_contact(const Tissue& tissue, const Vec3& point, const contact::Distance& distance,
                               const contact::Collider& collider) {
  contact::Contact c;
  c.a.kind = contact::ContactSide::Kind::soft;
  c.a.body = tissue.index;
  c.point = point;
  c.normal = distance.normal;
  c.gap = distance.value;
  c.b.body = collider.slot;
  if (!collider.fixed) {
    c.b.kind = contact::ContactSide::Kind::rigid;
    c.b.arm = point - collider.pose.p;
  }
  c.b.moved = kinematic_way(collider, point);
  c.friction = std::sqrt(tissue.desc().contact.friction * collider.friction);
  return c;
}

bool add_contacts(const Tissue& tissue, const contact::Collider& collider, double margin,
                  const contact::ContactMemories& held, double h, std::vector<contact::Contact>& out) {
  if (tissue.surface.proxy()) return add_proxy_contacts(tissue, collider, margin, out);
  const contact::SurfaceDetector& vertices = tissue.surface.vertices();
  const std::size_t before = out.size();
  const Vec3 near = Vec3::Constant(margin + tissue.half_thickness());
  if (rigid::is_room(collider.slot) &&
      !contact::boxes_overlap(collider.lo - near, collider.hi + near, vertices.lo(), vertices.hi()))
    return false;
  if (tissue.collision.over_area)
    add_area_contacts(tissue, collider, margin, held, out);
  else
    add_vertex_contacts(tissue, collider, margin, held, out);
  const Features features(tissue);
  add_between(tissue, collider, margin, held, features, out);
  contact::rest(held, features.first_face, h, std::span(out).subspan(before));
  return out.size() > before;
}

bool touches(const Tissue& tissue, const contact::Collider& collider, double margin) {
  if (!tissue.surface.proxy())
    return tissue.surface.vertices().touches(collider, margin + tissue.half_thickness());
  std::vector<contact::Contact> found;
  return add_proxy_contacts(tissue, collider, margin, found);
}

}  // namespace prosector
