#pragma once

#include <filesystem>

namespace prosector {

/// Returns $PROSECTOR_SHADERS unchanged. Empty if unset, which means the embedded shaders.
std::filesystem::path default_shader_dir();

}  // namespace prosector
