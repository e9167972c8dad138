#include "server/accuracy/foot.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double fading = 0.4;     // of the height
constexpr double stiffness = 100;  // times Young's modulus over the height squared

}  // namespace

Vec3 down(const Vec3& gravity) {
  return gravity.isZero() ? Vec3(-Vec3::UnitY()) : Vec3(gravity.normalized());
}

EndsAlong extent(const TetMesh& mesh, const Vec3& axis) {
  const auto [low, high] =
      std::minmax_element(mesh.positions.begin(), mesh.positions.end(),
                          [&](const Vec3& a, const Vec3& b) { return axis.dot(a) < axis.dot(b); });
  return {axis.dot(*low), axis.dot(*high)};
}

bool tied(const SoftDesc& desc, const TetMesh& mesh) {
  const auto held = [&](const Vec3& x) {
    return std::any_of(desc.attach.begin(), desc.attach.end(), [&](const AttachDesc& tie) {
      return tie.stiffness > 0 && (x - tie.center).norm() <= tie.radius;
    });
  };
  return std::any_of(mesh.positions.begin(), mesh.positions.end(), held);
}

std::optional<Foot> foot_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity) {
  if (tied(desc, mesh)) return std::nullopt;
  Foot foot;
  foot.axis = down(gravity);
  const EndsAlong along = extent(mesh, foot.axis);
  foot.level = along.high;
  foot.depth = fading * along.length();
  foot.stiffness = stiffness * desc.material.youngs_modulus / (along.length() * along.length());
  return foot;
}

VecX ties_of(const Foot& foot, const StaticBody& body) {
  VecX ties = body.volume();
  for (Eigen::Index i = 0; i < ties.size(); ++i) {
    const double above = foot.level - foot.axis.dot(body.rest().segment<3>(3 * i));
    const double share = std::clamp(1 - above / foot.depth, 0., 1.);
    ties[i] *= foot.stiffness * share * share;
  }
  return ties;
}

}  // namespace prosector
