#pragma once
// What a scene says by naming other files: label maps whose structures are bodies, and tables of names.

#include <cstddef>
#include <map>
#include <string>

#include "common/anatomy/mask.h"
#include "common/anatomy/source_paths.h"
#include "common/scene/scene.h"

namespace prosector {

inline constexpr std::size_t least_voxels = 64;  // of a structure that is taken unasked: fewer are noise

/// Returns the scene with a body for each structure of its atlases, in place of them. Its bodies have the
/// names that its table of labels has for them; a table that is missing is told of.
/// Throws InputError, which names the atlas, the label and its file, for
///   a label map or an atlas's table that is missing, or no such file
///   voxels that are no labels
///   names in `only` and `leave_out` that the table doesn't have, or that leave no structure
///   a body's name that is taken, or more bodies than a scene may have
SceneDesc completed(SceneDesc scene, const SourcePaths& paths, const Progress& progress);

/// Counts the voxels of each label but 0. Throws InputError, beginning with `where`, for voxels that are no
/// whole numbers in [0, 65535].
std::map<int, std::size_t> count_labels(const Volume& volume, const std::string& where);

}  // namespace prosector
