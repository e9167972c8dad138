#pragma once
// Hints about scene content that is allowed but probably not intended.

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace prosector {

/// Returns messages for the author, each with an oddity and its remedy; empty if there is none.
std::vector<std::string> scene_hints(const SceneDesc& scene);

}  // namespace prosector
