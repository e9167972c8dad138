#include "server/physics/stations/dissecting/blade_grip.h"

#include <algorithm>
#include <utility>

#include "server/physics/stations/dissecting/sheet_grip.h"
#include "server/physics/stations/dissecting/tissue_near.h"

namespace prosector {
namespace {

/// Adds and removes blades as hands grasp and release them.
void take_up_blades(State& state) {
  Bodies& bodies = state.bodies;
  const auto holder_of = [&](std::size_t slot) {
    return std::find_if(state.hands.begin(), state.hands.end(),
                        [&](const hands::Hand& hand) { return hand.hold && hand.hold->body == slot; });
  };
  std::erase_if(state.dissection.blades,
                [&](const organs::Blade& blade) { return holder_of(blade.slot) == state.hands.end(); });
  for (std::size_t slot = 0; slot < bodies.model.blades.size(); ++slot) {
    const auto holder = holder_of(slot);
    if (bodies.model.blades[slot].edges.empty() || holder == state.hands.end()) continue;
    auto at = std::lower_bound(state.dissection.blades.begin(), state.dissection.blades.end(), slot,
                               [](const organs::Blade& blade, std::size_t s) { return blade.slot < s; });
    if (at == state.dissection.blades.end() || at->slot != slot) {
      at = state.dissection.blades.insert(at, organs::Blade{});
      at->slot = slot;
      at->cut_to = edge_points(bodies, slot);
    }
    at->holder = holder->participant;
    const bool begins_or_ends = std::exchange(at->drawn, holder->draws) != holder->draws;
    if (begins_or_ends && !at->cutting) at->stroke = 0;  // a drawn cut is a separate stroke
  }
}

}  // namespace

std::vector<Vec3> edge_points(const Bodies& bodies, std::size_t slot) {
  const Pose frame = bodies.rigid.motion(slot).pose * bodies.model.rigid[slot].center.inverse();
  std::vector<Vec3> out;
  for (const organs::BladeShape::Edge& edge : bodies.model.blades[slot].edges)
    for (const Vec3& point : edge.points) out.push_back(frame * point);
  return out;
}

void grip_blades(State& state, std::vector<organs::BladeGrip>& grips) {
  Bodies& bodies = state.bodies;
  grips.clear();
  take_up_blades(state);
  for (const organs::Blade& blade : state.dissection.blades) {
    const std::vector<Vec3> now = edge_points(bodies, blade.slot);
    const std::vector<TissueNear> near = tissue_near(bodies, swept_box(blade.cut_to, blade.cut_to));
    const rigid::RigidMotion& tool = bodies.rigid.motion(blade.slot);
    std::size_t p = 0;
    for (const organs::BladeShape::Edge& edge : bodies.model.blades[blade.slot].edges) {
      const Vec3 along = (now[p + edge.points.size() - 1] - now[p]).normalized();
      for (std::size_t k = 0; k < edge.points.size(); ++k, ++p) {
        std::optional<organs::BladeGrip> grip = tissue_at(near, blade.cut_to[p]);
        if (!grip || edge.ray) continue;
        const SoftDesc& tissue = bodies.soft[grip->body].solver->desc();
        const Vec3 arm = now[p] - tool.pose.p, lag = now[p] - blade.cut_to[p];
        const double force = (blade.cutting ? 1 : organs::to_begin_cut) * tissue.material.toughness *
                             edge.length_per_point * organs::slicing(lag, along);
        if (!(force > 0)) continue;
        grip->slot = blade.slot;
        grip->point = p;
        contact::Tie& tie = grip->tie;
        tie.a.kind = contact::ContactSide::Kind::rigid;
        tie.a.body = blade.slot;
        tie.a.arm = arm;
        tie.b.kind = contact::ContactSide::Kind::soft;
        tie.b.body = grip->body;
        tie.b.add(grip->row, 1);
        tie.offset = lag;
        tie.stiffness = force / organs::edge_give;
        tie.max_force = force;
        bodies.soft[grip->body].wake();
        grips.push_back(*grip);
      }
    }
    grip_sheets(bodies, grips, blade, now);
  }
}

}  // namespace prosector
