#include "server/physics/stations/dissecting/tissue_near.h"

namespace prosector {

collision::Aabb swept_box(std::span<const Vec3> from, std::span<const Vec3> to) {
  collision::Aabb box;
  for (const auto points : {from, to})
    for (const Vec3& x : points) box.add(x);
  return box;
}

std::vector<TissueNear> tissue_near(const Bodies& bodies, const collision::Aabb& box) {
  std::vector<TissueNear> out;
  for (std::size_t i = 0; i < bodies.soft.size(); ++i) {
    const TetMesh& mesh = bodies.soft[i].solver->anatomy().tets;
    if (bodies.parts[bodies.soft_id(i)].out_of_touch() || mesh.tets.empty()) continue;
    const VecX& x = bodies.soft[i].state.motion.x;
    const auto nodes = x.reshaped(3, x.size() / 3);
    if (collision::Aabb{nodes.rowwise().minCoeff(), nodes.rowwise().maxCoeff()}.overlaps(box))
      out.push_back({i, organs::Locator(mesh, x, box)});
  }
  return out;
}

std::optional<organs::BladeGrip> tissue_at(std::span<const TissueNear> tissue, const Vec3& point) {
  for (const TissueNear& near : tissue)
    if (const auto row = near.locator.at(point))
      return organs::BladeGrip{near.body, 0, 0, *row, {}, Vec3::Zero(), {}};
  return std::nullopt;
}

}  // namespace prosector
