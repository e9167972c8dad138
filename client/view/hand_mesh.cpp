#include "client/view/hand_mesh.h"

#include "client/view/normals.h"

namespace prosector {

std::shared_ptr<DrawMesh> make_hand_mesh(const HandSkin& skin, std::uint64_t mesh_id) {
  auto mesh = std::make_shared<DrawMesh>();
  mesh->id = mesh_id;
  mesh->rest_positions = skin.rest();
  mesh->triangles = skin.triangles();
  bend_hand(skin, *mesh, {});
  return mesh;
}

void bend_hand(const HandSkin& skin, DrawMesh& mesh, const std::array<double, fingers>& flexion) {
  skin.bend(flexion, mesh.positions);
  smooth_normals(mesh.positions, mesh.triangles, mesh.normals);
  ++mesh.positions_revision;
}

}  // namespace prosector
