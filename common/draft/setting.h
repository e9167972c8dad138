#pragma once
// The surroundings of a draft scene's bodies: a table, a scalpel, a camera that shows all bodies, and lights.

#include <string>
#include <string_view>

#include "common/math.h"

namespace prosector {

inline constexpr double table_top = 0.9;     // m above the floor
inline constexpr double above_table = 2e-3;  // m: gap between the table and the bodies on it

/// Returns the camera, table and lights of a draft scene as TOML. `box` (m, room frame) bounds the scene's
/// bodies.
std::string setting_toml(const Eigen::AlignedBox3d& box);

inline constexpr std::string_view scalpel_name = "scalpel",
                                  table_name = "table";  // of the draft's own bodies

/// Returns, as TOML, a scalpel on a draft scene's table, to the right of the bodies that are bounded by `box`
/// (m, room frame).
std::string scalpel_toml(const Eigen::AlignedBox3d& box);

/// Returns the translation (m) that moves `box`, the bounds of a draft scene's bodies, onto the middle of the
/// table.
Vec3 shift_onto_table(const Eigen::AlignedBox3d& box);

}  // namespace prosector
