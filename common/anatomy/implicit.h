#pragma once
// Built-in shapes as signed distance fields: recognisable organs and bones for scenes without data, and
// simple bodies for comparisons. Composed of exact distances to primitives and smooth unions.

#include <string>
#include <string_view>
#include <vector>

#include "common/anatomy/field.h"

namespace prosector {

struct ImplicitShape {
  std::string_view name;
  std::string_view description;
  Vec3 natural_size;  // m: bounding box of an adult's organ, or a usual size
  /// Returns the approximate signed distance (m) of the shape's surface from a point `x` of the shape's
  /// frame, negative inside. The shape's bounding box is about [−1/2, 1/2]³ times natural_size.
  double (*value)(const Vec3& x);
};

/// Returns the built-in implicit shapes: liver, kidney, gallbladder, femur, foot, block, ball, beam,
/// cylinder, capsule, horseshoe.
const std::vector<ImplicitShape>& implicit_shapes();

/// Returns the built-in shape called `name` as a solid, scaled to a bounding box of `size` metres that is
/// centred at the origin. Throws InputError for a size that isn't positive, or for an unknown name, with a
/// list of the names.
SolidField implicit_shape(std::string_view name, const Vec3& size);

/// Returns the usual size (m) of the built-in shape called `name`, such as an adult's organ. Throws
/// InputError for an unknown name, with a list of the names.
Vec3 natural_size(std::string_view name);

}  // namespace prosector
