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

/// Returns the names of the CSV columns of recorded samples in order: time, station, x y z, qw qx qy qz,
/// thumb … little, gesture, buttons.
const std::vector<std::string>& sample_columns();

/// Reads the tracker station (receiver) of a row. The file counts from 1, the result from 0; an empty cell
/// means station 1 of the file. Throws InputError with file and line.
std::uint32_t read_station(const CsvTable& table, std::size_t row);
/// Reads the pose of a row (m, room frame) and normalises its quaternion. Returns nothing if all its cells
/// are empty. Without a quaternion the orientation is the identity. Throws InputError with file and line.
std::optional<Pose> read_pose(const CsvTable& table, std::size_t row);
/// Reads the finger flexions of a row, thumb first, each from 0 (open) to 1 (closed). Returns nothing if all
/// their cells are empty. Throws InputError with file and line.
std::optional<std::array<double, fingers>> read_flexion(const CsvTable& table, std::size_t row);

}  // namespace prosector
