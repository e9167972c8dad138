#pragma once
// The files that a scene names.

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace prosector {

/// Returns the files as the scene names them: meshes, volumes, label maps, tables of labels. Each is there
/// once.
std::vector<std::string> files_named_by(const SceneDesc& scene);

}  // namespace prosector
