#pragma once
// Points of a soft body's surface, interpolated by its elements' shape functions.

#include "server/physics/world/tissue.h"

namespace prosector {

/// Returns the side of a contact (nodes and weights) at a point of a soft body's surface triangle with
/// barycentric `weights`. Uses quadratic shape functions if the triangle lies in one quadratic element, so
/// that an even pressure gives consistent node loads. Otherwise interpolates the triangle's corners linearly.
contact::ContactSide surface_side(const Tissue& tissue, std::uint32_t triangle, const Vec3& weights);

/// Returns the side of a contact (nodes and weights) at a vertex of a soft body's surface.
contact::ContactSide surface_side(const Tissue& tissue, std::uint32_t vertex);

/// Returns the size (m, at rest) of the elements in which a surface triangle lies: the edge of a cube whose
/// face is two such triangles. For a triangle in several elements, it is the mean over those of its corners
/// that lie inside of elements or faces.
double element_size(const Tissue& tissue, std::uint32_t triangle);

/// Returns the current position (m, world frame) of a contact's point on a soft body, from the body's node
/// positions.
Vec3 place_of(const contact::ContactSide& side, const Tissue& tissue);

}  // namespace prosector
