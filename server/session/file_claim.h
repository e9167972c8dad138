#pragma once
// A file that one process at a time works with, of those that ask here.

#include <filesystem>

namespace prosector {

class FileClaim {
 public:
  /// Claims the file. Throws InputError when another process has claimed it. Where the file system knows no
  /// such claims, none is made.
  explicit FileClaim(const std::filesystem::path& file);
  ~FileClaim();
  FileClaim(const FileClaim&) = delete;
  FileClaim& operator=(const FileClaim&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace prosector
