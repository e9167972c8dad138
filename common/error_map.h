#pragma once
// What a body's error is at a place, from the map of it that travels.

#include <cstdint>
#include <optional>

#include "common/messages.h"

namespace prosector {

// A level above 0 is least_mapped_error·10^((level − 1)/levels_a_decade): 254 of them go through five
// decades.
inline constexpr double least_mapped_error = 1e-4;
inline constexpr double levels_a_decade = 254. / 5;

/// Returns the level that is nearest to an error in its logarithm; 0: it is less than the least, or none.
std::uint8_t level_of(double error);
/// Returns the error that a level stands for, fraction; 0 of level 0.
double error_of(std::uint8_t level);

/// Returns the map's value at a place of the shape at rest (m, world frame). It is linear along each axis
/// from one value to the next; beyond the map it is that at its nearest place. Nothing where the map has no
/// values.
std::optional<double> error_at(const ErrorMap& map, const Vec3& place);

}  // namespace prosector
