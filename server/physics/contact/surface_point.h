#pragma once
// Points of a soft body's surface as its elements' own functions tell them.

#include "server/physics/tissue.h"

namespace prosector {

/// Returns the side of a contact at a point of a surface triangle, `weights` its corners'. Of quadratic
/// elements it has their quadratic functions where the triangle lies in one of them, so that an even pressure
/// loads nodes as it must. Elsewhere it has the triangle's corners', which are linear in their nodes.
ContactSide surface_side(const Tissue& tissue, std::uint32_t triangle, const Vec3& weights);

/// Returns the same at a surface vertex.
ContactSide surface_side(const Tissue& tissue, std::uint32_t vertex);

/// Returns the size of the elements that a surface triangle lies in, at rest: of the cube whose face is two
/// such triangles, m. Of one that spans several it is the mean of those that its corners hang in.
double element_size(const Tissue& tissue, std::uint32_t triangle);

/// Returns where a soft side is now, m.
Vec3 place_of(const ContactSide& side, const Tissue& tissue);

}  // namespace prosector
