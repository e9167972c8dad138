#include "common/scene/scene_files.h"

#include <set>

namespace prosector {

std::vector<std::string> referenced_files(const SceneDesc& scene) {
  std::set<std::string> out = {scene.labels};
  for (const RigidDesc& body : scene.rigid) out.insert({body.mesh, body.volume});
  for (const SoftDesc& body : scene.soft) out.insert({body.mesh, body.volume});
  for (const AtlasDesc& atlas : scene.atlases) out.insert({atlas.volume, atlas.labels});
  out.erase("");
  return {out.begin(), out.end()};
}

}  // namespace prosector
