#pragma once
// The table on disk: measured once for a machine and a build.

#include <filesystem>
#include <string>

#include "server/calibration/rung_table.h"

namespace prosector {

/// Returns what figures hold for: CPU, cores, compiler, and this very executable, since other code takes
/// other time.
std::string machine_and_build();

/// What was found at `file`: a table, or none and why not ("" where there was no file).
struct FoundTable {
  RungTable table;
  std::string trouble;
};
/// Reads a table. One of another machine or build, or a damaged one, counts as none.
FoundTable read_table(const std::filesystem::path& file, const std::string& machine);
/// The least share of the processor at which figures are kept. Below it, what a rung costs was measured
/// beside other work, which also takes caches and memory: such figures serve once.
inline constexpr double least_share = 0.9;

/// Writes the rows that were measured undisturbed. Returns false when the file can't be written: no error, it
/// will be measured again.
bool write_table(const std::filesystem::path& file, const std::string& machine, const RungTable& table);

}  // namespace prosector
