#pragma once
// Detects changes of shader files. Private to client/render.

#include <filesystem>
#include <map>

namespace prosector {

class ShaderWatch {
 public:
  explicit ShaderWatch(const std::filesystem::path& folder) : folder_(folder), written_(times()) {}
  /// Returns true once after each write, addition or removal of a file in the folder.
  bool changed();

 private:
  using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
  Times times() const;

  std::filesystem::path folder_;
  Times written_;
};

}  // namespace prosector
