#pragma once
// Evaluation of a body's error map (ErrorMap in common/messages.h).

#include <cstdint>
#include <optional>

#include "common/error_estimate.h"
#include "common/math.h"

namespace prosector {

// A level above 0 stands for the error min_mapped_error·10^((level − 1)/levels_per_decade); 254 levels cover
// five decades.
inline constexpr double min_mapped_error = 1e-4;
inline constexpr double levels_per_decade = 254. / 5;

/// Returns the level nearest to `error` on a logarithmic scale; 0 for an error below the least level, or
/// none.
std::uint8_t level_of(double error);
/// Returns the error of a level as a fraction; 0 for level 0.
double error_of(std::uint8_t level);

/// Returns the error at a position of the rest shape (m, world frame) by trilinear interpolation. Positions
/// outside the map use its nearest point. Returns nullopt for a map without values.
std::optional<double> error_at(const ErrorMap& map, const Vec3& place);

}  // namespace prosector
