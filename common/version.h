#pragma once
// Which release this is: the one that CMakeLists.txt names.

#include <string>
#include <string_view>

namespace prosector {

/// Returns what `--version` prints: "prosector-server 0.2.0".
std::string version_line(std::string_view program);

}  // namespace prosector
