#pragma once
// Shapes of our own as signed distance fields: organs and bones that a person recognises, for scenes without
// data, and simple bodies for comparisons. Built from exact distances of primitives and smooth unions.

#include <string>
#include <string_view>
#include <vector>

#include "common/anatomy/field.h"

namespace prosector {

struct ImplicitShape {
  std::string_view name;
  std::string_view description;
  Vec3 natural_size;  // m: bounding box of an adult's, or a usual one
  /// Returns the value at a point of the shape's own frame, where its bounding box is about [−1/2, 1/2]³
  /// times natural_size; negative inside, about a distance in metres.
  double (*value)(const Vec3& x);
};

/// Returns the table: liver, kidney, gallbladder, femur, foot, block, ball, beam, cylinder, capsule,
/// horseshoe.
const std::vector<ImplicitShape>& implicit_shapes();

/// Returns the shape called `name`, scaled to a bounding box of `size` metres, centred at the origin. Throws
/// InputError that lists the names, or when a size isn't positive.
SolidField implicit_shape(std::string_view name, const Vec3& size);

/// Returns natural_size of the shape called `name`; throws like implicit_shape.
Vec3 natural_size(std::string_view name);

}  // namespace prosector
