#include "client/view/still_scene.h"

#include <algorithm>

#include "client/view/body_mesh.h"
#include "client/view/carried_light.h"
#include "client/view/room.h"
#include "client/view/section.h"

namespace prosector {

DrawList still_scene(const SceneDesc& scene, const SourcePaths& paths, const Progress& progress) {
  DrawList list;
  list.items = room_items(1);
  const std::size_t first = list.items.size();
  std::uint64_t mesh_id = first + 1;
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
  for (std::size_t k = first; k < list.items.size(); ++k)
    if (is_openable(list.items[k].appearance)) list.items[k].solid = static_cast<std::uint32_t>(k);
  for (const LightDesc& light : scene.lights) {
    const auto carrier = std::find_if(scene.rigid.begin(), scene.rigid.end(), [&](const RigidDesc& body) {
      return !light.carrier.empty() && body.name == light.carrier;
    });
    list.lights.push_back(carrier == scene.rigid.end() ? LightInfo(light)
                                                       : light_in_room(carrier->pose, light));
  }
  return list;
}

}  // namespace prosector
