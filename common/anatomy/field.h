#pragma once
// A solid as a scalar field: the input of all meshing functions.

#include <functional>

#include "common/math.h"

namespace prosector {

/// An axis-aligned box, given by two opposite corners in metres.
struct Box {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();

  Vec3 size() const { return max - min; }
  Vec3 center() const { return 0.5 * (min + max); }
};

/// Implicit solid: the region where `value` is negative. `value` is continuous, and its zero set is inside
/// `box`. For signed distance fields `value` is in metres; a level-set field may have any unit.
struct SolidField {
  std::function<double(const Vec3&)> value;
  Box box;
};

/// Estimates the solid's volume (m³) from its field at `samples` × `samples` × `samples` points in its box.
double sampled_volume(const SolidField& field, int samples);

/// Returns the gradient of field.value at `x` by central differences, with a step of `step` metres.
Vec3 gradient(const SolidField& field, const Vec3& x, double step);

/// Finds the point between `inside` (field value `f_inside` < 0) and `outside` (field value `f_outside` >= 0)
/// at which the field is zero, by bisection and secant steps. Returns the fraction of the distance from
/// inside to outside, in (0, 1).
double crossing(const SolidField& field, const Vec3& inside, double f_inside, const Vec3& outside,
                double f_outside);

}  // namespace prosector
