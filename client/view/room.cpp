#include "client/view/room.h"

#include <array>

namespace prosector {
namespace {

/// Corners counter-clockwise seen from inside.
void add_quad(DrawMesh& mesh, const std::array<Vec3, 4>& corners) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalized();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3& x : corners) {
    mesh.positions.push_back(x.cast<float>());
    mesh.normals.push_back(normal.cast<float>());
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

DrawItem item(std::shared_ptr<const DrawMesh> mesh, Surface surface, const Vec3& color, double roughness) {
  DrawItem out;
  out.mesh = std::move(mesh);
  out.surface = surface;
  out.appearance = {color, roughness, 0};
  out.casts_shadow = false;
  return out;
}

}  // namespace

std::vector<DrawItem> room_items(std::uint64_t first_mesh_id, const RoomShape& shape) {
  const double x = shape.width / 2, z = shape.depth / 2, h = shape.height;
  auto floor = std::make_shared<DrawMesh>();
  floor->id = first_mesh_id;
  add_quad(*floor, {{{-x, 0, z}, {x, 0, z}, {x, 0, -z}, {-x, 0, -z}}});

  auto walls = std::make_shared<DrawMesh>();
  walls->id = first_mesh_id + 1;
  const std::array<Vec3, 4> round = {{{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 &a = round[k], &b = round[(k + 1) % 4], up(0, h, 0);
    add_quad(*walls, {{a, b, b + up, a + up}});
  }
  return {item(floor, Surface::floor, {0.30, 0.33, 0.34}, 0.45),
          item(walls, Surface::wall, {0.42, 0.47, 0.46}, 0.9)};
}

}  // namespace prosector
