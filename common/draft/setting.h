#pragma once
// What stands around the bodies of a draft: a table under them, a scalpel beside them, a camera that shows
// them all, lights.

#include <string>
#include <string_view>

#include "common/math.h"

namespace prosector {

inline constexpr double table_top = 0.9;     // m above the floor
inline constexpr double above_table = 2e-3;  // m: of what stands on it

/// Returns camera, table and lights as TOML, for bodies that fill `box` (m, in the room).
std::string setting_for(const Eigen::AlignedBox3d& box);

inline constexpr std::string_view scalpel_name = "scalpel",
                                  table_name = "table";  // of the draft's own bodies

/// Returns a scalpel as TOML that lies on the table, to the right of bodies that fill `box` (m, in the room).
std::string scalpel_beside(const Eigen::AlignedBox3d& box);

/// Returns the shift that puts what fills `box` onto the middle of the table.
Vec3 onto_table(const Eigen::AlignedBox3d& box);

}  // namespace prosector
