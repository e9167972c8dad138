#include "server/physics/stations/dissecting/blade_sweep.h"

#include <algorithm>

#include "server/physics/stations/dissecting/sheet_grip.h"
#include "server/physics/stations/dissecting/tissue_near.h"

namespace prosector {
namespace {

constexpr double entry_depth = 2e-4;  // m below the surface: depth at which tissue holds an entering point

/// Stops points that enter tissue from outside at the surface, until the tissue yields. Returns whether any
/// point is in tissue.
bool stop_at_the_surface(const Bodies& bodies, std::span<const Vec3> from, std::span<Vec3> to) {
  const std::vector<TissueNear> near = tissue_near(bodies, swept_box(from, to));
  const auto in_tissue = [&](const Vec3& point) { return tissue_at(near, point).has_value(); };
  bool any = false;
  for (std::size_t p = 0; p < to.size(); ++p) {
    if (!in_tissue(to[p])) continue;
    any = true;
    if (in_tissue(from[p])) continue;
    Vec3 outside = from[p], inside = to[p];
    for (int i = 0; i < organs::entry_halvings; ++i) {
      const Vec3 middle = (outside + inside) / 2;
      (in_tissue(middle) ? inside : outside) = middle;
    }
    const Vec3 way = (to[p] - from[p]).normalized();
    to[p] = inside + std::min(entry_depth, (to[p] - inside).norm()) * way;
  }
  return any;
}

/// Applies stop_at_the_surface() to the points of all edges except rays.
bool enter_volumes(const Bodies& bodies, const organs::Blade& blade, std::span<const Vec3> from,
                   std::span<Vec3> to) {
  std::vector<std::size_t> which;
  std::vector<Vec3> solid_from, solid_to;
  std::size_t p = 0;
  for (const organs::BladeShape::Edge& edge : bodies.model.blades[blade.slot].edges)
    for (std::size_t k = 0; k < edge.points.size(); ++k, ++p) {
      if (edge.ray) continue;
      which.push_back(p);
      solid_from.push_back(from[p]);
      solid_to.push_back(to[p]);
    }
  const bool in_tissue = stop_at_the_surface(bodies, solid_from, solid_to);
  for (std::size_t k = 0; k < which.size(); ++k) to[which[k]] = solid_to[k];
  return in_tissue;
}

}  // namespace

Sweep sweep_of(const Bodies& bodies, std::span<const organs::BladeGrip> grips, const organs::Blade& blade) {
  const std::vector<Vec3> now = edge_points(bodies, blade.slot);
  Sweep sweep{blade.cut_to, now};
  std::vector<Vec3>&from = sweep.from, &to = sweep.to;
  for (const organs::BladeGrip& grip : grips) {
    if (grip.slot != blade.slot || grip.through) continue;
    from[grip.point] = organs::point_of(grip.row, bodies.soft[grip.body].state.motion.x) + grip.beside;
    const Vec3 lag = now[grip.point] - from[grip.point];
    const bool holds = lag.norm() <= grip.tie.max_force / grip.tie.stiffness;
    to[grip.point] = holds ? from[grip.point] : Vec3(now[grip.point] - organs::edge_give * lag.normalized());
  }
  drag_edges(bodies, grips, blade, now, from, to);
  const bool in_volume = enter_volumes(bodies, blade, from, to);
  const bool in_sheet = stop_at_sheets(bodies, grips, blade, from, to);
  sweep.in_tissue = in_volume || in_sheet;
  return sweep;
}

}  // namespace prosector
