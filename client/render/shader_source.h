#pragma once
// GLSL files as one source text, and conversion of compiler logs to file and line.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// A shader's text with each `#include "file"` (relative to the shader folder) expanded. `files[n]` is source
/// string n of its #line directives; for embedded shaders it is the bare name.
struct ShaderSource {
  std::string text;
  std::vector<std::filesystem::path> files;
};

/// Reads a shader from the folder; empty: from the embedded shaders. `defines` are macros as "NAME" or "NAME
/// VALUE". Throws InputError if a file is missing or includes itself.
ShaderSource load_shader_source(const std::filesystem::path& folder, const std::string& file,
                                const std::vector<std::string>& defines);

/// Rewrites Mesa's "2:14(3): error: …" and NVIDIA's "2(14) : error …" as "lighting.glsl:14: error: …".
std::string readable_log(const std::string& log, const ShaderSource& source);

}  // namespace prosector
