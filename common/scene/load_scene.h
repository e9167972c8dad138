#pragma once
// Scene files (TOML) to SceneDesc.

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "common/scene/scene.h"

namespace prosector {

/// Reads a scene file. Throws InputError with file, line, field and what is allowed. Unknown keys are errors.
/// Opens no other file.
SceneDesc load_scene(const std::filesystem::path& file);

/// Returns a scene file's text. Throws InputError when it can't be read, is no regular file or is too large
/// for one.
std::string read_scene_text(const std::filesystem::path& file);

/// Reads a scene from text as load_scene does; `file` is only for messages and for resolving paths later.
SceneDesc parse_scene(std::string_view toml, const std::filesystem::path& file);

/// Writes docs/look-up/scene.md from the field table that scenes are read by.
void write_scene_manual(std::ostream& out);

}  // namespace prosector
