#pragma once
// Evaluation of a body's error map (ErrorMap in common/error_estimate.h).

#include <cstdint>
#include <optional>

#include "common/error_estimate.h"
#include "common/math.h"

namespace prosector {

// A level above 0 stands for the error min_mapped_error·10^((level − 1)/levels_per_decade); 254 levels cover
// five decades.
inline constexpr double min_mapped_error = 1e-4;
inline constexpr double levels_per_decade = 254. / 5;

/// Returns the level (0 to 255) nearest to the relative error `error` on a logarithmic scale, as which error
/// maps store it. Returns 0 for an error below that of level 1, or none.
std::uint8_t level_of(double error);
/// Returns the relative error (a fraction) for which a level of an error map stands; 0 for level 0.
double error_of(std::uint8_t level);

/// Returns the relative error that a body's error map has at a position of the body's rest shape (m, world
/// frame), by trilinear interpolation. Positions outside the map use its nearest point. Returns nullopt for a
/// map without values.
std::optional<double> error_at(const ErrorMap& map, const Vec3& place);

}  // namespace prosector
