#include "client/view/light_shaft.h"

#include <cmath>
#include <numbers>

#include "common/rotation_between.h"

namespace prosector {
namespace {

constexpr int sides = 48, rings = 6;
constexpr double lamp_share = 0.18;  // radius at the lamp, as a fraction of the base's radius
constexpr double strength = 0.34;    // fraction of the lamp's colour that the dust scatters
constexpr double beyond = 1.15;      // ratio of the shaft's width to the part's

}  // namespace

std::shared_ptr<const DrawMesh> shaft_mesh(std::uint64_t mesh_id) {
  auto mesh = std::make_shared<DrawMesh>();
  mesh->id = mesh_id;
  for (int ring = 0; ring <= rings; ++ring) {
    const double along = static_cast<double>(ring) / rings;
    const double radius = lamp_share + (1 - lamp_share) * along;
    for (int side = 0; side < sides; ++side) {
      const double angle = 2 * std::numbers::pi * side / sides;
      const Vec3 outward(std::cos(angle), std::sin(angle), 0);
      mesh->positions.push_back((radius * outward - along * Vec3::UnitZ()).cast<float>());
      mesh->normals.push_back(outward.cast<float>());
      mesh->rest_positions.emplace_back(static_cast<float>(along), 0.0F, 0.0F);
    }
  }
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t next = (side + 1) % sides;
      const std::uint32_t a = ring * sides + side, b = ring * sides + next, c = a + sides, d = b + sides;
      mesh->triangles.push_back({a, c, b});
      mesh->triangles.push_back({b, c, d});
    }
  return mesh;
}

void add_light_shaft(DrawList& list, const std::shared_ptr<const DrawMesh>& shaft, const Vec3& lamp,
                     const Vec3& color, const Vec3& part_middle, double part_radius) {
  const Vec3 way = part_middle - lamp;
  const double length = way.norm();
  if (length < 1e-3) return;
  DrawItem item;
  item.mesh = shaft;
  item.pose.q = rotation_between(-Vec3::UnitZ(), way);
  const Mat3 turn = item.pose.q.toRotationMatrix();
  item.shape.A =
      turn * Vec3(beyond * part_radius, beyond * part_radius, length).asDiagonal() * turn.transpose();
  item.shape.p = lamp;
  item.appearance = {.color = strength * color, .surface = Surface::emissive};
  item.casts_shadow = false;
  item.shaft = true;
  list.items.push_back(item);
}

}  // namespace prosector
