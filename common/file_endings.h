#pragma once
// File name endings, compared without regard to case.

#include <array>
#include <span>
#include <string_view>

namespace prosector {

/// File name endings of the medical volume formats that Prosector reads.
inline constexpr std::array<std::string_view, 4> volume_endings = {".inr", ".inr.gz", ".nii", ".nii.gz"};

/// Returns whether the file's name ends with one of `endings` (lower case), ignoring ASCII case.
bool has_ending(std::string_view file, std::span<const std::string_view> endings);
inline bool has_ending(std::string_view file, std::string_view ending) {
  return has_ending(file, std::span(&ending, 1));
}

}  // namespace prosector
