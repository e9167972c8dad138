#include "client/view/still_scene.h"

#include "client/view/body_mesh.h"
#include "client/view/room.h"

namespace prosector {

DrawList still_scene(const SceneDesc& scene, const SourcePaths& paths, const Progress& progress) {
  DrawList list;
  list.items = room_items(1);
  std::uint64_t mesh_id = list.items.size() + 1;
  for (const RigidDesc& body : scene.rigid)
    list.items.push_back({.mesh = rigid_mesh(make_surface(body, paths, progress), mesh_id++),
                          .pose = body.pose,
                          .appearance = body.appearance});
  for (const SoftDesc& body : scene.soft) {
    const Anatomy anatomy = make_anatomy(body, paths, progress);
    list.items.push_back({.mesh = soft_mesh(anatomy.surface, tube_diameter(anatomy), mesh_id++),
                          .pose = {},
                          .appearance = body.appearance});
  }
  list.lights.assign(scene.lights.begin(), scene.lights.end());
  return list;
}

}  // namespace prosector
