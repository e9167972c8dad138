#pragma once
// Measures the rendering time on this machine.

#include <filesystem>

#include "client/render/gl_context.h"

namespace prosector {

/// Renders a scene file seven times at medium quality, 800 × 600 pixels, and returns the median time of a
/// frame, s. Throws InputError if the scene can't be read or OpenGL fails.
double picture_time(GlContext& context, const std::filesystem::path& shaders,
                    const std::filesystem::path& scene);

}  // namespace prosector
