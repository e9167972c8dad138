#pragma once
// How finely a body collides.

#include <cstdint>

namespace prosector {

/// Collision shape of a body, coarsest first (docs/understand/collision.md).
enum class Fidelity : std::uint8_t { none, sphere, aabb, obb, hull, mesh };

}  // namespace prosector
