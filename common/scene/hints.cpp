#include "common/scene/hints.h"

namespace prosector {

std::vector<std::string> scene_hints(const SceneDesc& scene) {
  std::vector<std::string> out;
  if (scene.lights.empty())
    out.emplace_back(
        "hint: this scene has no light, so it is rendered dark; add a [[light]], e.g. with kind = "
        "\"directional\" and direction = [0, -1, -0.5]");
  return out;
}

}  // namespace prosector
