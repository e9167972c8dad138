#pragma once

#include <filesystem>

namespace prosector {

/// Returns the folder of shader files in the environment variable PROSECTOR_SHADERS. Empty if it is unset,
/// which selects the embedded shaders.
std::filesystem::path default_shader_dir();

}  // namespace prosector
