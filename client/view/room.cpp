#include "client/view/room.h"

#include <array>

namespace prosector {
namespace {

/// Makes a quad; its corners are counter-clockwise seen from inside.
DrawItem quad(std::uint64_t mesh_id, const std::array<Vec3, 4>& corners, const Appearance& appearance) {
  auto mesh = std::make_shared<DrawMesh>();
  mesh->id = mesh_id;
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalized();
  for (const Vec3& x : corners) {
    mesh->positions.push_back(x.cast<float>());
    mesh->normals.push_back(normal.cast<float>());
  }
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return {.mesh = mesh, .pose = {}, .appearance = appearance, .casts_shadow = false};
}

const Appearance floor_look = {{0.58, 0.58, 0.57}, 0.9, 0, Surface::floor};
const Appearance wall_look = {{0.88, 0.89, 0.87}, 0.9, 0, Surface::wall};
const Appearance ceiling_look = {{0.80, 0.80, 0.79}, 0.9, 0, Surface::ceiling};

}  // namespace

std::vector<DrawItem> room_items(std::uint64_t first_mesh_id, const RoomShape& shape) {
  const double x = shape.width / 2, z = shape.depth / 2, h = shape.height;
  std::vector<DrawItem> out;
  const auto add = [&](const std::array<Vec3, 4>& corners, const Appearance& look) {
    out.push_back(quad(first_mesh_id + out.size(), corners, look));
  };
  constexpr int tiles = 5;  // per side
  for (int i = 0; i < tiles; ++i)
    for (int k = 0; k < tiles; ++k) {
      const double x0 = -x + 2 * x * i / tiles, x1 = -x + 2 * x * (i + 1) / tiles;
      const double z0 = -z + 2 * z * k / tiles, z1 = -z + 2 * z * (k + 1) / tiles;
      add({{{x0, 0, z1}, {x1, 0, z1}, {x1, 0, z0}, {x0, 0, z0}}}, floor_look);
    }
  const std::array<Vec3, 4> round = {{{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 &a = round[k], &b = round[(k + 1) % 4], up(0, h, 0);
    add({{a, b, b + up, a + up}}, wall_look);
  }
  add({{{-x, h, -z}, {x, h, -z}, {x, h, z}, {-x, h, z}}}, ceiling_look);
  return out;
}

}  // namespace prosector
