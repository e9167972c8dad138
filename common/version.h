#pragma once
// The program's version, from CMakeLists.txt.

#include <string>
#include <string_view>

namespace prosector {

/// Returns the line that a program prints for `--version`, such as "prosector-server 0.2.0".
std::string version_line(std::string_view program);

}  // namespace prosector
