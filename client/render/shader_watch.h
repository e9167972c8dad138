#pragma once
// Detects changes of shader files. Private to client/render.

#include <filesystem>
#include <map>

namespace prosector {

class ShaderWatch {
 public:
  explicit ShaderWatch(const std::filesystem::path& folder) : folder_(folder), written_(times()) {}
  /// Returns whether a file in the shader folder was written, added or removed since the last call.
  bool changed();

 private:
  using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
  Times times() const;

  std::filesystem::path folder_;
  Times written_;
};

}  // namespace prosector
