#include "client/view/blade_frame.h"

namespace prosector {

std::optional<BladeFrame> blade_frame(const RigidReplica& body) {
  const CuttingEdge* longest = nullptr;
  const auto length = [](const CuttingEdge& edge) { return (edge.to - edge.from).norm(); };
  for (const CuttingEdge& edge : body.edges)
    if (longest == nullptr || length(edge) > length(*longest)) longest = &edge;
  if (longest == nullptr || length(*longest) <= 0) return std::nullopt;
  Eigen::AlignedBox3d box;
  for (const Vec3& x : body.mesh.positions) box.extend(x);
  const Vec3 middle = box.isEmpty() ? Vec3(Vec3::Zero()) : box.center();
  const bool at_end = (longest->to - middle).norm() >= (longest->from - middle).norm();
  BladeFrame out;
  out.tip = at_end ? longest->to : longest->from;
  out.length = length(*longest);
  out.along = (at_end ? 1 : -1) / out.length * (longest->to - longest->from);
  // The edge faces away from the instrument's middle.
  const Vec3 outwards = out.tip - middle;
  const Vec3 across = outwards - outwards.dot(out.along) * out.along;
  constexpr double least = 1e-6;  // m: an edge through the middle has no defined direction
  out.ahead = across.norm() > least ? across.normalized() : out.along.unitOrthogonal();
  return out;
}

BladeFrame operator*(const Pose& pose, const BladeFrame& blade) {
  return {pose * blade.tip, pose.q * blade.along, pose.q * blade.ahead, blade.length};
}

}  // namespace prosector
