#pragma once
// A file that a test writes.

#include <unistd.h>

#include <filesystem>
#include <string>

namespace prosector::test {

/// A file name of its own, gone at the end.
struct TemporaryFile {
  std::filesystem::path path;
  explicit TemporaryFile(const std::string& name)
      : path(std::filesystem::temp_directory_path() / (name + "." + std::to_string(getpid()))) {
    remove();
  }
  ~TemporaryFile() { remove(); }
  void remove() const {
    for (const char* suffix : {"", "-wal", "-shm", "-journal"})
      std::filesystem::remove(path.string() + suffix);
  }
};

}  // namespace prosector::test
