#pragma once
// Blocks of liver tissue under their own weight, standing on a glued foot or hanging from it. Elements are
// less accurate the larger weight over stiffness is, and the nearer ν is to 0.5.

#include "server/accuracy/static_body.h"

namespace prosector {

struct WeighedBody {
  const char* name;
  Vec3 size;  // m; the foot is the face at y = 0
};
inline const WeighedBody weighed_cube = {"cube", {0.1, 0.1, 0.1}}, weighed_slab = {"slab", {0.2, 0.06, 0.2}};

inline constexpr double weighed_modulus = 5400, weighed_density = 1060;  // Pa, kg/m³
using Cells = std::array<std::uint32_t, 3>;

/// Returns the scene description of the body, with the tissue law (stable neo-Hookean).
SoftDesc weighed_desc(const WeighedBody& body, const char* element, double poisson_ratio);

/// Static solution of a mesh of the body.
struct Weighed {
  /// `gravity`: m/s² along y; the body stands if negative, else it hangs.
  Weighed(const SoftDesc& desc, Anatomy mesh, double gravity);
  StaticBody body;
  StaticAnswer answer;
};

}  // namespace prosector
