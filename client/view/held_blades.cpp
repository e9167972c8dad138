#include "client/view/held_blades.h"

namespace prosector {
namespace {

const Vec3 edge_color{1, 0.88, 0.4};
constexpr double edge_width = 2, guide_width = 1.6;  // points
constexpr double reach = 0.08;                       // m: largest distance of tissue ahead of the tip
constexpr double behind = 0.015, ahead = 0.025;      // m

}  // namespace

bool is_held_blade(const Replica& replica, BodyId body) {
  const PartState* part = replica.part(body);
  const RigidReplica* rigid = replica.bodies().rigid(body);
  return rigid != nullptr && !rigid->edges.empty() && part != nullptr && !part->hidden &&
         !part->holders.empty();
}

void add_edges(DrawList& list, const std::vector<CuttingEdge>& edges, const Pose& pose) {
  for (const CuttingEdge& edge : edges)
    list.lines.push_back({.a = pose * edge.from,
                          .b = pose * edge.to,
                          .color = edge_color,
                          .width = edge_width,
                          .faint_when_occluded = true});
}

std::vector<Vec3> next_cut(const Replica& replica, const BladeFrame& blade, const FindSurface& find) {
  const auto point = find({blade.tip - blade.length * blade.along, blade.along}, std::nullopt);
  if (!point || point->distance > blade.length + reach) return {};
  if (replica.scene()->bodies[point->body].kind != BodyKind::soft) return {};
  const Vec3 along = blade.ahead - blade.ahead.dot(point->normal) * point->normal;
  // An edge that faces almost straight into the surface has no cutting direction.
  constexpr double aslant = 0.2;
  if (along.norm() < aslant) return {};
  return draped_line(find, *point, along.normalized(), behind, ahead);
}

void add_guide(DrawList& list, const std::vector<Vec3>& line) {
  for (std::size_t k = 1; k < line.size(); ++k)
    list.lines.push_back({.a = line[k - 1], .b = line[k], .color = edge_color, .width = guide_width});
}

}  // namespace prosector
