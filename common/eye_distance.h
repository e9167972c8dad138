#pragma once
// Default interpupillary distance.

namespace prosector {

inline constexpr double default_interpupillary_distance = 0.063;  // m, average of adults

}  // namespace prosector
