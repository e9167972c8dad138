#pragma once
// Files referenced by a scene.

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace prosector {

/// Returns the paths as written in the scene: meshes, volumes, label maps, label tables. Each path occurs
/// once.
std::vector<std::string> referenced_files(const SceneDesc& scene);

}  // namespace prosector
