#pragma once
// Files that may change on disk while somebody runs on what they held.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace prosector {

/// Looks at files and says when they have changed, once a change has come to rest: editors write in pieces.
class FileWatch {
 public:
  /// Watches the files that `files` returns at each look; one that isn't there counts as missing. What they
  /// are now is no change.
  explicit FileWatch(std::function<std::vector<std::filesystem::path>()> files);

  /// Looks. Returns true once per change: when the files are as at the look before, but not as they were when
  /// this last returned true.
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
