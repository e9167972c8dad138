#pragma once
// Detects changes of files on disk.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace prosector {

/// Monitor of files that polls them and reports a change once it is complete, because editors write files in
/// several steps.
class FileWatch {
 public:
  /// Watches the files whose list `files` returns at each poll. A file of the list that doesn't exist counts
  /// as missing, so its creation is a change. The files' current state is no change.
  explicit FileWatch(std::function<std::vector<std::filesystem::path>()> files);

  /// Polls the files. Returns true once per change: when the files are as in the previous poll, but not as
  /// they were when the function last returned true.
  bool changed();

 private:
  struct Stamp {
    std::filesystem::path file;
    std::filesystem::file_time_type written{};
    std::uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  std::function<std::vector<std::filesystem::path>()> files_;
  std::vector<Stamp> settled_, last_;

  std::vector<Stamp> look() const;
};

}  // namespace prosector
