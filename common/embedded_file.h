#pragma once
// Files embedded in the executable, so that none has to be found at run time (common/embed_files.cmake).

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace prosector {

struct EmbeddedFile {
  std::string_view name;  // without its folder
  std::string_view text;
};

/// Returns the text of the file in `files` (embedded in the executable) with that name, or nullopt if there
/// is none.
inline std::optional<std::string_view> find_embedded(std::span<const EmbeddedFile> files,
                                                     std::string_view name) {
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& file) { return file.name == name; });
  if (found == files.end()) return std::nullopt;
  return found->text;
}

}  // namespace prosector
