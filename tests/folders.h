#pragma once
// Where the sources and the build are that a test belongs to. The paths are compiled into one small file, so
// that a second clone takes all tests but that file from the compiler's cache.

#include <string>
#include <string_view>

namespace prosector {

/// Returns the absolute path of a file or folder in the source folder: "deploy/scenes/cut.toml".
std::string source_path(std::string_view inside);
/// Returns the absolute path of a file or folder in the build folder: "bin/prosector-server".
std::string build_path(std::string_view inside);

}  // namespace prosector
