#pragma once
// Scene files (TOML) to SceneDesc.

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "common/scene/scene.h"

namespace prosector {

/// Reads a scene file. Throws InputError with file, line, field and the allowed values if it is invalid.
/// Unknown keys are errors. Opens no other file.
SceneDesc load_scene(const std::filesystem::path& file);

/// Returns a scene file's text. Throws InputError if it can't be read, is no regular file, or is too large
/// for a scene file.
std::string read_scene_text(const std::filesystem::path& file);

/// Parses a scene from text, with the same checks as load_scene(). `file` is only used in messages and to
/// resolve paths later.
SceneDesc parse_scene(std::string_view toml, const std::filesystem::path& file);

/// Writes the manual of scene files, docs/look-up/scene.md, to `out`. It is made from the same field table
/// with which scenes are read.
void write_scene_manual(std::ostream& out);

/// Returns the paths of all files to which the scene refers (meshes, volumes, label maps and label tables),
/// as written in the scene. Each path occurs once.
std::vector<std::string> referenced_files(const SceneDesc& scene);

/// Returns messages for the scene's author about content that is allowed but probably not intended, each with
/// a remedy. Empty if there is none.
std::vector<std::string> scene_hints(const SceneDesc& scene);

}  // namespace prosector
