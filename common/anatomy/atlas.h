#pragma once
// Expansion of a scene's references: atlases (label maps whose structures become bodies) and tables of names.

#include <cstddef>
#include <map>
#include <string>

#include "common/anatomy/mask.h"
#include "common/anatomy/search_paths.h"
#include "common/scene/scene.h"

namespace prosector {

inline constexpr std::size_t min_structure_voxels =
    64;  // a smaller structure is noise, unless named in `only`

/// Returns the scene with each atlas (label map) replaced by one body per labelled structure. Bodies get
/// their localised names from the scene's label table; a missing table is reported.
/// Throws InputError that names the atlas, the label and its file for
///   a missing or invalid label map or atlas table,
///   voxels that aren't labels,
///   names in `only` and `leave_out` that the table doesn't have, or that leave no structure, and
///   a body name that is taken, or more bodies than a scene may have.
SceneDesc completed(SceneDesc scene, const SourcePaths& paths, const Progress& progress);

/// Returns the number of voxels of each label in the volume, except label 0. Throws InputError, whose text
/// begins with `where`, for voxel values that aren't integers in [0, 65535].
std::map<int, std::size_t> count_labels(const Volume& volume, const std::string& where);

}  // namespace prosector
