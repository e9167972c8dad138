#pragma once
// The columns that recordings and motion scripts share.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/math.h"
#include "common/messages.h"
#include "drivers/csv.h"

namespace prosector {

/// Returns time, station, x y z, qw qx qy qz, thumb … little, gesture, buttons.
const std::vector<std::string>& sample_columns();

/// Reads the station, counted from 1 in files, from 0 here; default 1. Throws InputError with file and line,
/// as the next two functions do.
std::uint32_t read_station(const CsvTable& table, std::size_t row);
/// Reads the pose, normalised. Returns nothing when all its cells are empty; without a quaternion, the
/// identity.
std::optional<Pose> read_pose(const CsvTable& table, std::size_t row);
/// Reads the flexions, each in [0, 1]. Returns nothing when all their cells are empty.
std::optional<std::array<double, fingers>> read_flexion(const CsvTable& table, std::size_t row);

}  // namespace prosector
