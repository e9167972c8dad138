#pragma once
// Options of stored frames: screenshots, a video and a contact sheet.

#include <filesystem>
#include <optional>
#include <vector>

namespace prosector {

struct Screenshot {
  std::filesystem::path file;
  std::optional<double> at;  // s after joining; nullopt: at the end
};

/// Files of stored frames; an empty path: none.
struct OutputOptions {
  std::vector<Screenshot> screenshots;
  std::filesystem::path video, sheet;
  double sheet_interval = 10;  // s between two images of `sheet`
};

}  // namespace prosector
