#pragma once
// How long a picture takes here.

#include <filesystem>

#include "client/render/gl_context.h"

namespace prosector {

/// Draws a scene some times at medium quality, 800 × 600, and returns the median time of a picture, s. Throws
/// InputError where the scene can't be read or OpenGL refuses.
double picture_time(GlContext& context, const std::filesystem::path& shaders,
                    const std::filesystem::path& scene);

}  // namespace prosector
