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
  /// Returns the approximate signed distance (m) at a point of the shape's frame, negative inside. The
  /// bounding box is about [−1/2, 1/2]³ times natural_size.
  double (*value)(const Vec3& x);
};

/// Returns the shapes: liver, kidney, gallbladder, femur, foot, block, ball, beam, cylinder, capsule,
/// horseshoe.
const std::vector<ImplicitShape>& implicit_shapes();

/// Returns the shape called `name`, scaled to a bounding box of `size` metres, centred at the origin. Throws
/// InputError for a size that isn't positive, or for an unknown name, with a list of the names.
SolidField implicit_shape(std::string_view name, const Vec3& size);

/// Returns natural_size of the shape called `name`. Throws as implicit_shape does.
Vec3 natural_size(std::string_view name);

}  // namespace prosector
