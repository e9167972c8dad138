// Blades that hands hold: phase 3, what tissue their edges are in; last phase, what they cut.

#include <algorithm>

#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double hold = 2e-4;  // m below the surface, where tissue holds on to what enters it

}  // namespace

bool Simulation::Impl::is_held_blade(std::size_t slot) const {
  return std::any_of(blades.begin(), blades.end(), [&](const Blade& blade) { return blade.slot == slot; });
}

/// Blades come and go with the hands that hold them.
void Simulation::Impl::take_up_blades() {
  const auto holder_of = [&](std::size_t slot) {
    return std::find_if(hands.begin(), hands.end(),
                        [&](const Hand& hand) { return hand.hold && hand.hold->body == slot; });
  };
  std::erase_if(blades, [&](const Blade& blade) { return holder_of(blade.slot) == hands.end(); });
  for (std::size_t slot = 0; slot < blade_shapes.size(); ++slot) {
    const auto holder = holder_of(slot);
    if (blade_shapes[slot].edges.empty() || holder == hands.end()) continue;
    auto at = std::lower_bound(blades.begin(), blades.end(), slot,
                               [](const Blade& blade, std::size_t s) { return blade.slot < s; });
    if (at == blades.end() || at->slot != slot) {
      at = blades.insert(at, Blade{slot, 0, 0, false, 0, {}, {}});
      at->cut_to = edge_points(slot);
    }
    at->holder = holder->participant;
  }
}

std::vector<Vec3> Simulation::Impl::edge_points(std::size_t slot) const {
  const Pose frame = world.motion(slot).pose * model.rigid[slot].center.inverse();
  std::vector<Vec3> out;
  for (const BladeShape::Edge& edge : blade_shapes[slot].edges)
    for (const Vec3& point : edge.points) out.push_back(frame * point);
  return out;
}

Aabb Simulation::Impl::swept_box(std::span<const Vec3> from, std::span<const Vec3> to) {
  Aabb box;
  for (const auto points : {from, to})
    for (const Vec3& x : points) box.add(x);
  return box;
}

/// The tissue that can be touched near a box.
std::vector<Simulation::Impl::TissueNear> Simulation::Impl::tissue_near(const Aabb& box) const {
  std::vector<TissueNear> out;
  for (std::size_t i = 0; i < soft.size(); ++i) {
    const TetMesh& mesh = model.soft[i]->anatomy().tets;
    if (parts[soft_id(i)].out_of_touch() || mesh.tets.empty()) continue;
    const VecX& x = soft[i].motion.x;
    const auto nodes = x.reshaped(3, x.size() / 3);
    if (Aabb{nodes.rowwise().minCoeff(), nodes.rowwise().maxCoeff()}.overlaps(box))
      out.push_back({i, Locator(mesh, x, box)});
  }
  return out;
}

/// Which of it a point of that box is in.
std::optional<BladeGrip> Simulation::Impl::tissue_at(std::span<const TissueNear> tissue, const Vec3& point) {
  for (const TissueNear& near : tissue)
    if (const auto row = near.locator.at(point))
      return BladeGrip{near.body, 0, 0, *row, {}, Vec3::Zero(), {}};
  return std::nullopt;
}

void Simulation::Impl::grip_blades() {
  blade_grips.clear();
  take_up_blades();
  for (const Blade& blade : blades) {
    const std::vector<Vec3> now = edge_points(blade.slot);
    const std::vector<TissueNear> near = tissue_near(swept_box(blade.cut_to, blade.cut_to));
    const RigidMotion& tool = world.motion(blade.slot);
    std::size_t p = 0;
    for (const BladeShape::Edge& edge : blade_shapes[blade.slot].edges) {
      const Vec3 along = (now[p + edge.points.size() - 1] - now[p]).normalized();
      for (std::size_t k = 0; k < edge.points.size(); ++k, ++p) {
        std::optional<BladeGrip> grip = tissue_at(near, blade.cut_to[p]);
        if (!grip || edge.ray) continue;
        const SoftDesc& tissue = model.soft[grip->body]->desc();
        const Vec3 arm = now[p] - tool.pose.p, lag = now[p] - blade.cut_to[p];
        const double force = (blade.cutting ? 1 : to_begin_cut) * tissue.toughness * edge.length_per_point *
                             slicing(lag, along);
        if (!(force > 0)) continue;
        grip->slot = blade.slot;
        grip->point = p;
        Tie& tie = grip->tie;
        tie.a.kind = ContactSide::Kind::rigid;
        tie.a.body = blade.slot;
        tie.a.arm = arm;
        tie.b.kind = ContactSide::Kind::soft;
        tie.b.body = grip->body;
        tie.b.add(grip->row, 1);
        tie.offset = lag;
        tie.stiffness = force / edge_give;
        tie.max_force = force;
        wake_soft(grip->body);
        blade_grips.push_back(*grip);
      }
    }
    grip_sheets(blade, now);
  }
}

/// Where tissue lets go of an edge's points: what they sweep through is cut.
void Simulation::Impl::advance(Blade& blade) {
  const std::vector<Vec3> now = edge_points(blade.slot);
  std::vector<Vec3> from = blade.cut_to, to = now;
  for (const BladeGrip& grip : blade_grips) {
    if (grip.slot != blade.slot || grip.through) continue;
    from[grip.point] = point_of(grip.row, soft[grip.body].motion.x) + grip.beside;
    const Vec3 lag = now[grip.point] - from[grip.point];
    const bool holds = lag.norm() <= grip.tie.max_force / grip.tie.stiffness;
    to[grip.point] = holds ? from[grip.point] : Vec3(now[grip.point] - edge_give * lag.normalized());
  }
  drag_edges(blade, now, from, to);
  const bool in_volume = enter_volumes(blade, from, to), in_sheet = stop_at_sheets(blade, from, to);
  const bool in_tissue = in_volume || in_sheet;
  const bool begins = blade.stroke == 0 || blade.outside > between_strokes;
  if (in_tissue && begins) blade.stroke = ++strokes;
  blade.outside = in_tissue ? 0 : blade.outside + 1 / model.scene.tick_rate;
  std::size_t p = 0;
  const std::vector<BladeShape::Edge>& edges = blade_shapes[blade.slot].edges;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const std::size_t count = edges[edge].points.size();
    cut_tissue(blade, edge, std::span(from).subspan(p, count), std::span(to).subspan(p, count));
    p += count;
  }
  blade.cutting = in_tissue;
  blade.cut_to = std::move(to);
}

/// As stop_at_the_surface(), of what may enter.
bool Simulation::Impl::enter_volumes(const Blade& blade, std::span<const Vec3> from,
                                     std::span<Vec3> to) const {
  std::vector<std::size_t> which;
  std::vector<Vec3> solid_from, solid_to;
  std::size_t p = 0;
  for (const BladeShape::Edge& edge : blade_shapes[blade.slot].edges)
    for (std::size_t k = 0; k < edge.points.size(); ++k, ++p) {
      if (edge.ray) continue;
      which.push_back(p);
      solid_from.push_back(from[p]);
      solid_to.push_back(to[p]);
    }
  const bool in_tissue = stop_at_the_surface(solid_from, solid_to);
  for (std::size_t k = 0; k < which.size(); ++k) to[which[k]] = solid_to[k];
  return in_tissue;
}

/// What enters tissue from outside is held where it enters, until the tissue gives. Whether any point is in
/// tissue.
bool Simulation::Impl::stop_at_the_surface(std::span<const Vec3> from, std::span<Vec3> to) const {
  const std::vector<TissueNear> near = tissue_near(swept_box(from, to));
  const auto in_tissue = [&](const Vec3& point) { return tissue_at(near, point).has_value(); };
  bool any = false;
  for (std::size_t p = 0; p < to.size(); ++p) {
    if (!in_tissue(to[p])) continue;
    any = true;
    if (in_tissue(from[p])) continue;
    Vec3 outside = from[p], inside = to[p];
    for (int i = 0; i < entry_halvings; ++i) {
      const Vec3 middle = (outside + inside) / 2;
      (in_tissue(middle) ? inside : outside) = middle;
    }
    const Vec3 way = (to[p] - from[p]).normalized();
    to[p] = inside + std::min(hold, (to[p] - inside).norm()) * way;
  }
  return any;
}

}  // namespace prosector
