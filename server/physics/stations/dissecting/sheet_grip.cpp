#include "server/physics/stations/dissecting/sheet_grip.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "server/physics/mechanics/collision/primitives/closest_points.h"
#include "server/physics/mechanics/collision/primitives/segment_hit.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/stations/dissecting/tissue_near.h"

namespace prosector {
namespace {

constexpr double box_slack = 1e-6;  // m: rounding tolerance of the search box
// Height above the sheet at which approaching points are held, as a fraction of its thickness.
constexpr double above = 0.25;

SparseMap::Row row_of(const std::array<std::uint32_t, 3>& corners, const Vec3& weights) {
  return {{corners[0], corners[1], corners[2], 0}, {weights[0], weights[1], weights[2], 0}};
}

/// An intersection of an edge with a sheet.
struct SheetCrossing {
  std::size_t point = 0;  // index in the edge
  double share = 0;       // fraction of the way from that point to the next
  SparseMap::Row row;     // of the sheet's nodes
  Vec3 place = Vec3::Zero(), normal = Vec3::UnitY();
};

/// Triangles of a sheet near a box, in order.
struct NearSheet {
  struct Face {
    std::array<std::uint32_t, 3> corners;
    std::array<Vec3, 3> at;
    collision::Aabb box;
  };
  std::vector<Face> faces;

  NearSheet(const Anatomy& sheet, const VecX& x, const collision::Aabb& place) {
    const auto visit = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const std::array<Vec3, 3> at = {x.segment<3>(3 * Eigen::Index{a}), x.segment<3>(3 * Eigen::Index{b}),
                                      x.segment<3>(3 * Eigen::Index{c})};
      const collision::Aabb box{at[0].cwiseMin(at[1]).cwiseMin(at[2]), at[0].cwiseMax(at[1]).cwiseMax(at[2])};
      if (box.overlaps(place)) faces.push_back({{a, b, c}, at, box});
    };
    for (const auto& [a, b, c, d] : sheet.quads) {
      visit(a, b, c);
      visit(a, c, d);
    }
    for (const auto& [a, b, c] : sheet.triangles) visit(a, b, c);
  }

  /// Calls do_it(corners, positions) for each triangle whose box overlaps that of `points`, grown by
  /// `widened`.
  template <class F>
  void visit(std::span<const Vec3> points, double widened, const F& do_it) const {
    const collision::Aabb box = swept_box(points, points).grown(widened);
    for (const Face& face : faces)
      if (face.box.overlaps(box)) do_it(face.corners, face.at);
  }
};

bool can_cut_sheet(const Bodies& bodies, std::size_t body) {
  const Tissue& tissue = bodies.soft[body];
  return soft::mesh_kind(tissue.solver->anatomy()) == soft::MeshKind::sheet &&
         !bodies.parts[bodies.soft_id(body)].out_of_touch() && tissue.collision.fidelity != Fidelity::none;
}

/// Returns the intersections of the edge with the sheet, in order along the edge. An intersection on an edge
/// between triangles is reported once.
std::vector<SheetCrossing> sheet_crossings(const NearSheet& sheet, std::span<const Vec3> edge) {
  std::vector<SheetCrossing> out;
  if (edge.empty()) return out;
  sheet.visit(edge, 0, [&](const auto& corners, const std::array<Vec3, 3>& at) {
    for (std::size_t p = 0; p + 1 < edge.size(); ++p)
      if (const auto found = collision::segment_hit(edge[p], edge[p + 1], at))
        out.push_back({p, found->t, row_of(corners, found->weights),
                       edge[p] + found->t * (edge[p + 1] - edge[p]),
                       (at[1] - at[0]).cross(at[2] - at[0]).normalized()});
  });
  std::stable_sort(out.begin(), out.end(), [](const SheetCrossing& a, const SheetCrossing& b) {
    return a.point != b.point ? a.point < b.point : a.share < b.share;
  });
  constexpr double same = 1e-9;  // of the distance between two points
  out.erase(std::unique(out.begin(), out.end(),
                        [](const SheetCrossing& a, const SheetCrossing& b) {
                          return static_cast<double>(b.point) + b.share -
                                     (static_cast<double>(a.point) + a.share) <
                                 same;
                        }),
            out.end());
  return out;
}

/// A point at which a sheet holds an edge.
struct GripPoint {
  std::size_t point;              // index of the blade's point before it
  SparseMap::Row row;             // of the sheet
  Vec3 at_blade, at_sheet;        // m
  std::optional<double> through;  // fraction of the way to the next point, if the edge passes through
};

/// Adds a tie between sheet and blade with at most `force` N, and wakes the sheet.
void add_grip(Bodies& bodies, std::vector<organs::BladeGrip>& grips, const organs::Blade& blade,
              std::size_t body, const GripPoint& at, double force) {
  if (!(force > 0)) return;
  organs::BladeGrip made{body, blade.slot, at.point, at.row, at.through, Vec3::Zero(), {}};
  if (!at.through) made.beside = at.at_sheet - organs::point_of(at.row, bodies.soft[body].state.motion.x);
  contact::Tie& tie = made.tie;
  tie.a.kind = contact::ContactSide::Kind::rigid;
  tie.a.body = blade.slot;
  tie.a.arm = at.at_blade - bodies.rigid.motion(blade.slot).pose.p;
  tie.b.kind = contact::ContactSide::Kind::soft;
  tie.b.body = body;
  tie.b.add(at.row, 1);
  tie.offset = at.at_blade - at.at_sheet;
  tie.stiffness = force / organs::edge_give;
  tie.max_force = force;
  bodies.soft[body].wake();
  grips.push_back(std::move(made));
}

/// Returns the point of the sheet nearest to the given one, if less than `reach` (m) away; otherwise none.
std::optional<SparseMap::Row> nearest_in_sheet(const NearSheet& near, std::span<const Vec3> point,
                                               double reach) {
  std::optional<SparseMap::Row> row;
  near.visit(point, reach, [&](const auto& corners, const std::array<Vec3, 3>& at) {
    const Vec3 w = collision::closest_weights(point[0], at[0], at[1], at[2]);
    const double d = (w[0] * at[0] + w[1] * at[1] + w[2] * at[2] - point[0]).norm();
    if (d >= reach) return;
    reach = d;
    row = row_of(corners, w);
  });
  return row;
}

}  // namespace

void grip_sheets(Bodies& bodies, std::vector<organs::BladeGrip>& grips, const organs::Blade& blade,
                 std::span<const Vec3> now) {
  for (std::size_t body = 0; body < bodies.soft.size(); ++body) {
    if (!can_cut_sheet(bodies, body)) continue;
    const SoftDesc& desc = bodies.soft[body].solver->desc();
    const Anatomy& sheet = bodies.soft[body].solver->anatomy();
    const double toughness = (blade.cutting ? 1 : organs::to_begin_cut) * desc.material.toughness;
    std::size_t first = 0;
    for (const organs::BladeShape::Edge& edge : bodies.model.blades[blade.slot].edges) {
      const std::size_t count = edge.points.size();
      if (edge.ray) {
        first += count;
        continue;
      }
      const auto cut_to = std::span(blade.cut_to).subspan(first, count);
      const Vec3 along = (now[first + count - 1] - now[first]).normalized();
      const NearSheet near(sheet, bodies.soft[body].state.motion.x,
                           swept_box(cut_to, cut_to).grown(sheet.thickness / 2 + box_slack));
      const std::vector<SheetCrossing> crossings = sheet_crossings(near, cut_to);
      for (const SheetCrossing& c : crossings) {
        const std::size_t p = first + c.point;
        const Vec3 at_blade = now[p] + c.share * (now[p + 1] - now[p]);
        add_grip(bodies, grips, blade, body, {p, c.row, at_blade, c.place, c.share},
                 toughness * sheet.thickness * organs::slicing(at_blade - c.place, along, c.normal));
      }
      for (std::size_t k = 0; k < count && crossings.empty(); ++k)
        if (const auto row = nearest_in_sheet(near, cut_to.subspan(k, 1), sheet.thickness / 2))
          add_grip(bodies, grips, blade, body, {first + k, *row, now[first + k], cut_to[k], std::nullopt},
                   toughness * edge.length_per_point * organs::slicing(now[first + k] - cut_to[k], along));
      first += count;
    }
  }
}

void drag_edges(const Bodies& bodies, std::span<const organs::BladeGrip> grips, const organs::Blade& blade,
                std::span<const Vec3> now, std::span<Vec3> from, std::span<Vec3> to) {
  std::size_t first = 0;
  for (const organs::BladeShape::Edge& edge : bodies.model.blades[blade.slot].edges) {
    const std::size_t count = edge.points.size();
    for (std::size_t p = first; p < first + count; ++p) {
      if (std::any_of(grips.begin(), grips.end(), [&](const organs::BladeGrip& grip) {
            return grip.slot == blade.slot && !grip.through && grip.point == p;
          }))
        continue;  // held directly
      double nearest = std::numeric_limits<double>::infinity();
      for (const organs::BladeGrip& grip : grips) {
        if (grip.slot != blade.slot || !grip.through || grip.point < first || grip.point >= first + count)
          continue;
        const double away =
            std::abs(static_cast<double>(grip.point) + *grip.through - static_cast<double>(p));
        if (away >= nearest) continue;
        nearest = away;
        const Vec3 material = organs::point_of(grip.row, bodies.soft[grip.body].state.motion.x);
        const auto along = [&](std::span<const Vec3> x) -> Vec3 {
          return x[grip.point] + *grip.through * (x[grip.point + 1] - x[grip.point]);
        };
        const Vec3 lag = along(now) - material;
        const double give = grip.tie.max_force / grip.tie.stiffness;
        from[p] = blade.cut_to[p] + material - along(blade.cut_to);
        to[p] = now[p] - (lag.norm() <= give ? lag : Vec3(give * lag.normalized()));
      }
    }
    first += count;
  }
}

bool stop_at_sheets(const Bodies& bodies, std::span<const organs::BladeGrip> grips,
                    const organs::Blade& blade, std::span<const Vec3> from, std::span<Vec3> to) {
  bool in_sheet = false;
  for (std::size_t body = 0; body < bodies.soft.size(); ++body) {
    if (!can_cut_sheet(bodies, body)) continue;
    const Anatomy& sheet = bodies.soft[body].solver->anatomy();
    const VecX& x = bodies.soft[body].state.motion.x;
    std::size_t first = 0;
    for (const organs::BladeShape::Edge& edge : bodies.model.blades[blade.slot].edges) {
      const auto before = from.subspan(first, edge.points.size());
      const auto after = to.subspan(first, edge.points.size());
      const auto gripped = [&](std::size_t k) {
        return std::any_of(grips.begin(), grips.end(), [&](const organs::BladeGrip& g) {
          return g.slot == blade.slot && g.body == body && g.point == first + k;
        });
      };
      first += edge.points.size();
      const NearSheet near(sheet, x, swept_box(before, after).grown(box_slack));
      if (!sheet_crossings(near, before).empty()) {
        in_sheet = true;
        continue;
      }
      const bool tough = !edge.ray && bodies.soft[body].solver->desc().material.toughness > 0;
      for (std::size_t k = 0; k < before.size(); ++k) {
        const std::array<Vec3, 2> way = {before[k], after[k]};
        const Vec3 all = way[1] - way[0];
        double first_hit = 2, steepness = 0;
        near.visit(way, 0, [&](const auto&, const std::array<Vec3, 3>& at) {
          const auto found = collision::segment_hit(way[0], way[1], at);
          if (!found || found->t >= first_hit) return;
          first_hit = found->t;
          steepness = std::abs((at[1] - at[0]).cross(at[2] - at[0]).normalized().dot(all));
        });
        if (first_hit > 1) continue;
        in_sheet = true;
        if (!tough || gripped(k)) continue;
        const double back = above * sheet.thickness / std::max(1e-9, steepness);
        after[k] = way[0] + std::max(0.0, first_hit - back) * all;
      }
      if (sheet_crossings(near, after).empty()) continue;
      if (tough && !in_sheet) {  // the edge enters over the sheet's border
        const std::vector<Vec3> end(after.begin(), after.end());
        double out = 0, in = 1;
        for (int i = 0; i < organs::entry_halvings; ++i) {
          const double middle = (out + in) / 2;
          for (std::size_t k = 0; k < before.size(); ++k)
            after[k] = before[k] + middle * (end[k] - before[k]);
          (sheet_crossings(near, after).empty() ? out : in) = middle;
        }
        for (std::size_t k = 0; k < before.size(); ++k) after[k] = before[k] + in * (end[k] - before[k]);
      }
      in_sheet = true;
    }
  }
  return in_sheet;
}

}  // namespace prosector
