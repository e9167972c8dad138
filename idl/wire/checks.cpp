#include "idl/wire/checks.h"
#include "common/ids.h"
#include "common/part_messages.h"

namespace prosector {

bool within(const Vec3& v, double limit) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= limit;
}

Refusal check_pose(Pose& pose) {
  if (!is_finite(pose)) return "pose not finite";
  if (!within(pose.p, max_coordinate)) return "pose out of range";
  const double norm = pose.q.norm();
  if (std::abs(norm - 1) > quaternion_slack) return "quaternion not of unit length";
  // A unit quaternion is left unchanged bit by bit, so that repeated checks change nothing.
  if (std::abs(norm - 1) > 1e-12) pose.q.coeffs() /= norm;
  return {};
}

Refusal check_color(const Vec3& color) {
  const bool ok = color.allFinite() && color.minCoeff() >= 0 && color.maxCoeff() <= 1;
  return ok ? Refusal() : "colour outside [0, 1]";
}

Refusal check_shape(const Affine& shape) {
  constexpr double least_volume = 1e-6;  // determinant: scaling by 1/100 in each direction
  return Checks()
      .that(within(shape.p, max_coordinate), "the offset of a part's displayed shape is out of range")
      .that(shape.A.allFinite() && shape.A.cwiseAbs().maxCoeff() <= max_shape_entry, "shape out of range")
      .that(std::abs(shape.A.determinant()) >= least_volume, "the transform of an inspected body is singular")
      .refusal();
}

}  // namespace prosector
