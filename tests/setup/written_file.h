#pragma once
// Files that tests of the set-up window write and read.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace prosector::test {

/// Writes a file, and makes its folder.
inline void write_file(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}
inline std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace prosector::test
