#pragma once
// `--summary FILE`: the run's figures as JSON.

#include <filesystem>

#include "server/session/run/server_loop.h"

namespace prosector {

/// Writes the run's statistics as JSON to `file`. `journal` is the path of the journal, which is included.
/// Returns false if the file cannot be written.
bool write_summary(const std::filesystem::path& file, const ServerLoop& loop, const Simulation& simulation,
                   const std::filesystem::path& journal);

}  // namespace prosector
