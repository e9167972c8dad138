// Phase 3, for soft bodies that collide as a sphere, a box or a hull.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double sides = 6;  // of a box around a body: all that touches one side counts as a sixth of it

bool is_rough(Fidelity fidelity) {
  return fidelity != Fidelity::none && fidelity != Fidelity::mesh;
}

RigidOutline outline_of(const RigidShape& shape) {
  const bool mesh = !shape.parts.empty() && shape.parts.front().kind == ShapeKind::triangles;
  return RigidOutline(shape.parts, mesh ? Fidelity::mesh : Fidelity::hull);
}

}  // namespace

void Simulation::Impl::fit_rough_shape(std::size_t body) {
  rough[body].reset();
  if (!is_rough(model.soft_collision[body].fidelity)) return;
  rough[body].emplace(model.soft[body]->anatomy(), model.soft_collision[body].fidelity);
  if (!outlines.empty()) return;
  for (const RigidModel& r : model.rigid)
    outlines.push_back(r.shape.parts.empty() ? std::nullopt : std::optional(outline_of(r.shape)));
  for (const HandModel& hand : model.hands) outlines.push_back(outline_of(hand.shape));
  for (const RoomModel& room : model.room) outlines.push_back(outline_of(room.shape));
}

void Simulation::Impl::place_surface(std::size_t body) {
  surfaces[body].update(soft[body].motion.x.data());
  if (rough[body]) rough[body]->fit(soft[body].motion.x, surfaces[body].positions());
}

Aabb Simulation::Impl::outer_box(std::size_t body) const {
  if (rough[body]) return rough[body]->box();
  return Aabb{surfaces[body].lo(), surfaces[body].hi()}.grown(skin_of(body));
}

/// N/m, of all that touches one side of the shape: by the scene's factor stiffer than the body as a whole.
double Simulation::Impl::rough_stiffness(std::size_t body) const {
  const SoftDesc& desc = model.soft[body]->desc();
  const auto areas = model.soft[body]->surface_area();
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0) / sides;
  return model.scene.contact_stiffness * desc.youngs_modulus * std::sqrt(area);
}

const std::optional<RigidOutline>& Simulation::Impl::outline_at(std::size_t slot) const {
  const std::size_t first_hand = model.rigid.size(), first_side = first_hand + model.hands.size();
  if (is_room(slot)) return outlines[first_side + room_side(slot)];
  const Hand* hand = hand_at(slot);
  return outlines[hand ? first_hand + hand->side : slot];
}

bool Simulation::Impl::add_rough_contacts(std::size_t body, const Collider& collider, double margin,
                                          std::vector<Contact>& out) const {
  const RoughShape& own = *rough[body];
  if (!own.box().grown(margin).overlaps({collider.lo, collider.hi})) return false;
  const auto& outline = outline_at(collider.slot);
  if (!outline) return false;
  std::vector<CollisionPiece> pieces;
  outline->place(collider.pose, collider.part_poses, pieces);
  std::vector<ShapeTouch> touches;
  for (const CollisionPiece& piece : pieces)
    if (own.box().grown(margin).overlaps(prosector::box_of(piece)))
      find_touches(own.piece(), piece, margin, touches);
  const std::size_t shares = own.hanger().shares();
  const double stiffness = rough_stiffness(body) / static_cast<double>(touches.size() * shares);
  for (const ShapeTouch& touch : touches)
    for (std::size_t share = 0; share < shares; ++share) {
      Contact c = soft_contact(body, touch.point, {touch.gap, touch.normal}, collider);
      c.point = own.hanger().hang(touch.point, touch.normal, share, c.a);
      if (!collider.fixed) c.b.arm = c.point - collider.pose.p;
      c.stiffness = stiffness;
      out.push_back(c);
    }
  return !touches.empty();
}

/// Of two bodies of which one is rough at least.
bool Simulation::Impl::add_rough_pair_contacts(std::size_t a, std::size_t b, double margin,
                                               std::vector<Contact>& out) const {
  if (!rough[b]) return add_rough_pair_contacts(b, a, margin, out);
  const std::size_t before = out.size();
  if (rough[a]) {
    std::vector<ShapeTouch> touches;
    find_touches(rough[a]->piece(), rough[b]->piece(), margin, touches);
    const Hanger &of_a = rough[a]->hanger(), &of_b = rough[b]->hanger();
    const std::size_t shares = std::max(of_a.shares(), of_b.shares());
    const double own = rough_stiffness(a), other = rough_stiffness(b);
    for (const ShapeTouch& touch : touches)
      for (std::size_t share = 0; share < shares; ++share) {
        Contact& c = out.emplace_back(pair_contact(a, b, touch.normal, touch.gap));
        c.point = of_a.hang(touch.point, touch.normal, share % of_a.shares(), c.a);
        of_b.hang(touch.point, touch.normal, share % of_b.shares(), c.b);
        c.stiffness = 2 * own * other / (own + other) / static_cast<double>(touches.size() * shares);
      }
    return out.size() > before;
  }
  const RoughShape& shape = *rough[b];
  const double skin = skin_of(a);
  const Aabb reach = shape.box().grown(margin + skin);
  surfaces[a].in_box(reach.lo, reach.hi, [&](std::uint32_t vertex) {
    const Vec3& x = surfaces[a].positions()[vertex];
    const auto near = proximity(CollisionPiece(SphereShape{x, skin}), shape.piece(), margin);
    if (!near) return;
    Contact& c = out.emplace_back(pair_contact(a, b, near->normal, near->gap));
    c.a = surface_side(a, vertex);
    c.point = x;
    shape.hanger().hang(x, near->normal, vertex % shape.hanger().shares(), c.b);
    c.stiffness = pair_stiffness(a, b, vertex);
    c.feature = vertex;
    recall(find(memories[a], c.b, c.feature), c);
  });
  return out.size() > before;
}

}  // namespace prosector
