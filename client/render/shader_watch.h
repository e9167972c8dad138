#pragma once
// Sees when a shader file changed. Private to client/render.

#include <filesystem>
#include <map>

namespace prosector {

class ShaderWatch {
 public:
  explicit ShaderWatch(const std::filesystem::path& folder) : folder_(folder), written_(times()) {}
  /// Returns true once for every time that a file of the folder was written, added or removed.
  bool changed();

 private:
  using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
  Times times() const;

  std::filesystem::path folder_;
  Times written_;
};

}  // namespace prosector
