#pragma once
// Options of measurement files.

#include <filesystem>

namespace prosector {

/// Files to which a session is logged; an empty path: none.
struct LogOptions {
  std::filesystem::path latency;   // times of sent inputs or received snapshots, CSV
  std::filesystem::path pictures;  // times, camera images and hand poses of drawn frames, CSV
  std::filesystem::path session;   // session events, JSON lines
  std::filesystem::path summary;   // of the run, JSON
};

}  // namespace prosector
