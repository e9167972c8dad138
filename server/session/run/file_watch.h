#pragma once
// Detects changes of files on disk.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace prosector {

/// Polls files and reports a change once it is complete: editors write in pieces.
class FileWatch {
 public:
  /// Watches the files that `files` returns at each poll; one that doesn't exist counts as missing. Their
  /// present state is no change.
  explicit FileWatch(std::function<std::vector<std::filesystem::path>()> files);

  /// Polls the files. Returns true once per change: when the files are as at the poll before, but not as they
  /// were when this last returned true.
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
