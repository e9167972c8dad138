#pragma once
// A lock on a file, held by one process at a time among those that use this class.

#include <filesystem>

namespace prosector {

class FileClaim {
 public:
  /// Locks the file. Throws InputError when another process holds the lock. On a file system without locks,
  /// none is taken.
  explicit FileClaim(const std::filesystem::path& file);
  ~FileClaim();
  FileClaim(const FileClaim&) = delete;
  FileClaim& operator=(const FileClaim&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace prosector
