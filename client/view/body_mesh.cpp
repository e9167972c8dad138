#include "client/view/body_mesh.h"

#include "client/view/normals.h"
#include "client/view/tube.h"

namespace prosector {
namespace {

/// Returns the mesh's long axis, along x, y or z; zero if the mesh is not slender.
Vec3 slender_axis(const std::vector<Eigen::Vector3f>& positions) {
  constexpr float least = 5;  // ratio of length to width
  Eigen::AlignedBox3f box;
  for (const auto& x : positions) box.extend(x);
  if (box.isEmpty()) return Vec3::Zero();
  Eigen::Vector3f size = box.sizes();
  Eigen::Index axis = 0;
  const float length = size.maxCoeff(&axis);
  size[axis] = 0;
  return length >= least * size.maxCoeff() ? Vec3(Vec3::Unit(axis)) : Vec3(Vec3::Zero());
}

}  // namespace

std::shared_ptr<DrawMesh> rigid_mesh(const TriangleMesh& surface, std::uint64_t mesh_id) {
  CreasedMesh creased = split_creases(surface);
  auto out = std::make_shared<DrawMesh>();
  out->id = mesh_id;
  out->positions = std::move(creased.positions);
  out->normals = std::move(creased.normals);
  out->triangles = std::move(creased.triangles);
  out->slender = slender_axis(out->positions);
  return out;
}

std::shared_ptr<DrawMesh> soft_mesh(const TriangleMesh& rest, double tube_diameter, std::uint64_t mesh_id) {
  std::vector<Eigen::Vector3f> surface;
  for (const Vec3& x : rest.positions) surface.push_back(x.cast<float>());
  if (tube_diameter > 0 && !surface.empty())
    return tube_mesh(surface, static_cast<float>(tube_diameter), mesh_id);
  auto out = std::make_shared<DrawMesh>();
  out->id = mesh_id;
  out->rest_positions = surface;
  out->positions = std::move(surface);
  out->triangles = rest.triangles;
  smooth_normals(out->positions, out->triangles, out->normals);
  return out;
}

void move_soft_mesh(std::span<const Eigen::Vector3f> surface, double tube_diameter, DrawMesh& mesh) {
  if (tube_diameter > 0 && !surface.empty()) {
    sweep_tube(surface, static_cast<float>(tube_diameter), mesh);
  } else {
    mesh.positions.assign(surface.begin(), surface.end());
    smooth_normals(mesh.positions, mesh.triangles, mesh.normals);
  }
  ++mesh.positions_revision;
}

}  // namespace prosector
