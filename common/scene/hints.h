#pragma once
// What is allowed in a scene, but hardly what its author wants.

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace prosector {

/// Returns lines for people, each saying what is odd and what to write instead; none: nothing is.
std::vector<std::string> scene_hints(const SceneDesc& scene);

}  // namespace prosector
