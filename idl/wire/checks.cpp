#include "idl/wire/checks.h"

namespace prosector {

bool within(const Vec3& v, double limit) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= limit;
}

Refusal check_pose(Pose& pose) {
  if (!is_finite(pose)) return "pose not finite";
  if (!within(pose.p, max_coordinate)) return "pose out of range";
  const double norm = pose.q.norm();
  if (std::abs(norm - 1) > quaternion_slack) return "quaternion not unit";
  // A quaternion that is unit already keeps its bits, so that checking twice changes nothing.
  if (std::abs(norm - 1) > 1e-12) pose.q.coeffs() /= norm;
  return {};
}

Refusal check_color(const Vec3& color) {
  const bool ok = color.allFinite() && color.minCoeff() >= 0 && color.maxCoeff() <= 1;
  return ok ? Refusal() : "colour outside [0, 1]";
}

Refusal check_shape(const Affine& shape) {
  constexpr double least_volume = 1e-6;  // of what it was: a hundredth in each direction
  return Checks()
      .that(within(shape.p, max_coordinate), "shape moved out of the room")
      .that(shape.A.allFinite() && shape.A.cwiseAbs().maxCoeff() <= most_shape, "shape out of range")
      .that(std::abs(shape.A.determinant()) >= least_volume, "shape collapsed")
      .refusal();
}

}  // namespace prosector
