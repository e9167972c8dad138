#pragma once
// Estimated error of a deformable body: its parts, its map over the body, and its price in CPU time.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Components of a soft body's estimated error, as fractions. Where the direction is known, a component has a
/// sign: positive if the body is stiffer than real tissue.
struct ErrorParts {
  double discretisation = 0;  // error of mesh and elements
  double model = 0;           // error of the constitutive law, compared with tissue at the occurring strains
  double solver = 0;          // error of the last tick's solve, ≥ 0
  double time = 0;            // error of the last tick's step length, ≥ 0
};

inline constexpr std::size_t max_error_map_side = 10;  // values
inline constexpr std::size_t max_error_map_values =
    max_error_map_side * max_error_map_side * max_error_map_side;

/// Spatial distribution of a soft body's estimated error: values on a grid over its rest shape, interpolated
/// trilinearly. The mean over the body's volume is the body's error.
struct ErrorMap {
  Vec3 corner = Vec3::Zero();             // m, world frame: position of the first value
  double cell = 0;                        // m: grid spacing
  std::array<std::uint8_t, 3> size{};     // number of values along x, y, z; all 0: unknown
  std::vector<std::uint8_t> levels = {};  // x fastest; error_of() in common/error_map.h decodes them
};

/// Error and cost of one model configuration of a soft body, from which the host can choose.
struct Price {
  double error = 0;  // of displacements or indentations, fraction
  double ms = 0;     // CPU time per frame of 1/60 s
};
inline constexpr std::size_t max_configuration_costs = 8;

}  // namespace prosector
