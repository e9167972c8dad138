#include "client/view/value_painter.h"

#include <optional>
#include <utility>

namespace prosector {
namespace {

std::vector<DrawnBodies::Item> soft_items(const DrawnBodies& drawn, const Replica& replica) {
  const auto& bodies = replica.scene()->bodies;
  std::vector<DrawnBodies::Item> out;
  for (const DrawnBodies::Item& one : drawn.items())
    if (bodies[one.body].kind == BodyKind::soft) out.push_back(one);
  return out;
}

}  // namespace

ValueScale ValuePainter::paint(DrawList& list, const DrawnBodies& bodies, const Replica& replica, Shown shown,
                               std::uint64_t& next_mesh_id) {
  const std::vector<DrawnBodies::Item> soft = soft_items(bodies, replica);
  ValueScale scale = scale_of(shown);
  if (shown == Shown::strain) scale.most = strain_limit(list, soft, next_mesh_id);
  for (const DrawnBodies::Item& one : soft)
    paint(list.items[one.index], scale, shown, replica.body_status(one.body), next_mesh_id);
  return scale;
}

/// Returns the upper limit of the scale for the strains of these items.
double ValuePainter::strain_limit(const DrawList& list, const std::vector<DrawnBodies::Item>& items,
                                  std::uint64_t& next_mesh_id) {
  std::vector<double> strains;
  for (const DrawnBodies::Item& one : items) {
    const DrawMesh& mesh = *list.items[one.index].mesh;
    const std::vector<double>& of_mesh = painted_of(mesh, next_mesh_id).strains(mesh);
    strains.insert(strains.end(), of_mesh.begin(), of_mesh.end());
  }
  return strain_range_.follow(std::move(strains));
}

void ValuePainter::paint(DrawItem& item, const ValueScale& scale, Shown shown, const BodyStatus* status,
                         std::uint64_t& next_mesh_id) {
  std::optional<double> value;  // of the whole body
  if (shown == Shown::residual) value = status != nullptr ? status->residual : not_known;
  const bool known = status != nullptr && status->error >= 0;
  if (shown == Shown::error) value = known ? status->error : not_known;
  const ErrorMap* map = shown == Shown::error && known ? &status->error_map : nullptr;
  item.mesh = painted_of(*item.mesh, next_mesh_id).of(*item.mesh, scale, value, map);
  item.painted = true;
}

PaintedMesh& ValuePainter::painted_of(const DrawMesh& mesh, std::uint64_t& next_mesh_id) {
  const auto [painted, is_new] = painted_.try_emplace(mesh.id, next_mesh_id);
  if (is_new) ++next_mesh_id;
  return painted->second;
}

}  // namespace prosector
