#pragma once
// CSV columns shared by recordings and motion scripts.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/hand_pose.h"
#include "common/math.h"
#include "drivers/files/csv.h"

namespace prosector {

/// Returns time, station, x y z, qw qx qy qz, thumb … little, gesture, buttons.
const std::vector<std::string>& sample_columns();

/// Reads the station, numbered from 1 in files and from 0 here; default 1. Throws InputError with file and
/// line, as do the next two functions.
std::uint32_t read_station(const CsvTable& table, std::size_t row);
/// Reads the pose and normalises it. Returns nothing if all its cells are empty. Without a quaternion the
/// orientation is the identity.
std::optional<Pose> read_pose(const CsvTable& table, std::size_t row);
/// Reads the flexions, each in [0, 1]. Returns nothing if all their cells are empty.
std::optional<std::array<double, fingers>> read_flexion(const CsvTable& table, std::size_t row);

}  // namespace prosector
