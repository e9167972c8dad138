#pragma once
// Blocks of liver tissue that bear their own weight on a glued foot, or hang from it: the heavier for its
// stiffness and the less compressible, the harder for elements.

#include "server/accuracy/static_body.h"

namespace prosector {

struct WeighedBody {
  const char* name;
  Vec3 size;  // m; the foot is the face at y = 0
};
inline const WeighedBody weighed_cube = {"cube", {0.1, 0.1, 0.1}}, weighed_slab = {"slab", {0.2, 0.06, 0.2}};

inline constexpr double weighed_modulus = 5400, weighed_density = 1060;  // Pa, kg/m³
using Cells = std::array<std::uint32_t, 3>;

/// Describes the body, of tissue's law (stable neo-Hookean).
SoftDesc weighed_desc(const WeighedBody& body, const char* element, double poisson_ratio);

/// Where a mesh of the body comes to rest.
struct Weighed {
  /// `gravity`: m/s² along y; below 0 it stands.
  Weighed(const SoftDesc& desc, Anatomy mesh, double gravity);
  StaticBody body;
  StaticAnswer answer;
};

}  // namespace prosector
