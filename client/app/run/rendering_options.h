#pragma once
// Options of the rendering quality and the shaders.

#include <filesystem>
#include <optional>

#include "client/render/renderer.h"

namespace prosector {

struct RenderingOptions {
  QualityLevel quality = quality_levels[1];
  std::optional<double> frame_time;  // target frame time for automatic quality, s; nullopt: fixed quality
  std::filesystem::path shaders;     // folder
  bool watch_shaders = false;        // reload shaders when a file changes
};

}  // namespace prosector
