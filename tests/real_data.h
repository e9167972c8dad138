#pragma once
// Files that the set-up fetches, where they are there.

#include <filesystem>
#include <string>
#include <system_error>

#include "common/paths.h"

namespace prosector {

/// Empty: it is not below default_data_dir().
inline std::string find_in_data(const std::string& name) {
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(default_data_dir(), error))
    if (entry.path().filename() == name) return entry.path().string();
  return "";
}

}  // namespace prosector
