#pragma once
// The table of rungs on disk, measured once for a machine and a build.

#include <filesystem>
#include <string>

#include "server/calibration/rung_table.h"

namespace prosector {

/// Returns the machine and build that figures hold for: CPU, cores, compiler, and hash of this executable.
std::string machine_and_build();

/// Result of reading `file`: a table, or none and the reason ("" where there was no file).
struct FoundTable {
  RungTable table;
  std::string trouble;
};
/// Reads a table. Returns none if it is of another machine or build, or damaged.
FoundTable read_table(const std::filesystem::path& file, const std::string& machine);
/// Least share of processor time at which figures are stored. Below it other programs ran during the
/// measurement, and also used caches and memory: such figures are used in this run only.
inline constexpr double least_share = 0.9;

/// Writes the rows that were measured undisturbed. Returns false when the file can't be written. That is no
/// error: the rungs will be measured again.
bool write_table(const std::filesystem::path& file, const std::string& machine, const RungTable& table);

}  // namespace prosector
