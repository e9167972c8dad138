#pragma once
// A lock on a file, held by one process at a time among those that use this class.

#include <filesystem>

namespace prosector {

class FileClaim {
 public:
  /// Locks the file. Throws InputError if another process holds the lock. Does nothing on a file system that
  /// does not support locks.
  explicit FileClaim(const std::filesystem::path& file);
  ~FileClaim();
  FileClaim(const FileClaim&) = delete;
  FileClaim& operator=(const FileClaim&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace prosector
