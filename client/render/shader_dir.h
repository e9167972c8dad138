#pragma once

#include <filesystem>

namespace prosector {

/// The first that exists of: $PROSECTOR_SHADERS, the source tree's shaders/, the installed one. When
/// $PROSECTOR_SHADERS is set it is taken as it is. Throws InputError saying where it looked.
std::filesystem::path default_shader_dir();

}  // namespace prosector
