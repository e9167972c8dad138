#include "client/view/body_mesh.h"

#include "client/view/normals.h"

namespace prosector {

std::shared_ptr<DrawMesh> rigid_mesh(const TriangleMesh& surface, std::uint64_t mesh_id) {
  CreasedMesh creased = split_creases(surface);
  auto out = std::make_shared<DrawMesh>();
  out->id = mesh_id;
  out->positions = std::move(creased.positions);
  out->normals = std::move(creased.normals);
  out->triangles = std::move(creased.triangles);
  return out;
}

std::shared_ptr<DrawMesh> soft_mesh(const TriangleMesh& rest, std::uint64_t mesh_id) {
  auto out = std::make_shared<DrawMesh>();
  out->id = mesh_id;
  for (const Vec3& x : rest.positions) out->positions.push_back(x.cast<float>());
  out->rest_positions = out->positions;
  out->triangles = rest.triangles;
  smooth_normals(out->positions, out->triangles, out->normals);
  return out;
}

}  // namespace prosector
