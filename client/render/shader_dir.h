#pragma once

#include <filesystem>

namespace prosector {

/// Returns $PROSECTOR_SHADERS as it is; empty when it is unset: the shaders that are part of the program.
std::filesystem::path default_shader_dir();

}  // namespace prosector
