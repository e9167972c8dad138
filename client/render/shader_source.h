#pragma once
// GLSL files as one source text, and conversion of compiler logs to file and line.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// Text of a shader with each `#include "file"` (relative to the shader folder) expanded. `files[n]` is the
/// file to which number n refers in the text's #line directives; an embedded file is listed by its bare name.
struct ShaderSource {
  std::string text;
  std::vector<std::filesystem::path> files;
};

/// Reads a shader file from the folder, or from the embedded files if `folder` is empty, and expands its
/// #include lines. `defines` are macros as "NAME" or "NAME VALUE". Throws InputError if a file is missing or
/// is included twice.
ShaderSource load_shader_source(const std::filesystem::path& folder, const std::string& file,
                                const std::vector<std::string>& defines);

/// Returns a compiler log with file names in place of file numbers. Mesa's "2:14(3): error: …" and NVIDIA's
/// "2(14) : error …" become "lighting.glsl:14: error: …".
std::string readable_log(const std::string& log, const ShaderSource& source);

}  // namespace prosector
