#pragma once
// The table of rungs on disk, measured once for a machine and a build.

#include <filesystem>
#include <string>

#include "server/calibration/rung_table.h"

namespace prosector {

/// Returns text that identifies the machine and build for which measured costs are valid: CPU, cores,
/// compiler, and hash of this executable.
std::string machine_and_build();

/// Result of reading a table of measured configurations from a file: the table, or an empty one and the
/// reason ("" if there was no file).
struct FoundTable {
  RungTable table;
  std::string error;
};
/// Reads the table of measured configurations from `file`. Returns an empty table and the reason if the file
/// is of another machine or build than `machine`, or damaged.
FoundTable read_table(const std::filesystem::path& file, const std::string& machine);
/// Least ratio of CPU time to wall time at which a measurement is stored in the table's file. Below it other
/// programs ran during the measurement, and also used caches and memory. Such figures are used in this run
/// only.
inline constexpr double least_share = 0.9;

/// Writes the rows of the table that were measured undisturbed by other programs. Returns false if the file
/// can't be written. That is no error: the configurations will be measured again.
bool write_table(const std::filesystem::path& file, const std::string& machine, const RungTable& table);

}  // namespace prosector
