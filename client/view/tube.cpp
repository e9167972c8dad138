#include "client/view/tube.h"

#include <cmath>

#include "common/rotation_between.h"

namespace prosector {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr std::uint32_t sides = 12;
constexpr std::uint32_t cap_rings = 4;  // per end, from its pole to just before the first or last point

std::size_t ring_count(std::size_t points) {
  return points + 2 * cap_rings;
}

/// Returns the unit tangent of the line at point `i`: the normalised sum of the directions before and after.
/// Zero if both have no length.
Vec3f tangent_at(std::span<const Vec3f> axis, std::size_t i) {
  Vec3f sum = Vec3f::Zero();
  if (i > 0) sum += (axis[i] - axis[i - 1]).normalized();
  if (i + 1 < axis.size()) sum += (axis[i + 1] - axis[i]).normalized();
  return sum.norm() > 1e-6F ? sum.normalized() : Vec3f(Vec3f::Zero());
}

/// Adds one ring of vertices. `across` and `along`: offsets from `centre` perpendicular to and along the
/// tangent, in units of the radius. On a unit sphere they are the components of the normal.
void lay_ring(const Vec3f& centre, const Vec3f& tangent, const Vec3f& side, float radius, float across,
              float along, std::size_t ring, DrawMesh& tube) {
  const Vec3f other = tangent.cross(side);
  for (std::uint32_t s = 0; s < sides; ++s) {
    const float angle = 2 * static_cast<float>(M_PI) * static_cast<float>(s) / sides;
    const Vec3f out = std::cos(angle) * side + std::sin(angle) * other;
    const Vec3f normal = across * out + along * tangent;
    tube.positions[ring * sides + s] = centre + radius * normal;
    tube.normals[ring * sides + s] = normal;
  }
}

}  // namespace

std::shared_ptr<DrawMesh> tube_mesh(std::span<const Vec3f> axis, float diameter, std::uint64_t mesh_id) {
  auto out = std::make_shared<DrawMesh>();
  out->id = mesh_id;
  const auto rings = static_cast<std::uint32_t>(ring_count(axis.size()));
  out->positions.resize(std::size_t{rings} * sides);
  out->normals.resize(out->positions.size());
  for (std::uint32_t r = 0; r + 1 < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      const std::uint32_t a = r * sides + s, b = r * sides + (s + 1) % sides;
      out->triangles.push_back({a, b, b + sides});
      out->triangles.push_back({a, b + sides, a + sides});
    }
  sweep_tube(axis, diameter, *out);
  out->rest_positions = out->positions;
  return out;
}

void sweep_tube(std::span<const Vec3f> axis, float diameter, DrawMesh& tube) {
  const float radius = diameter / 2;
  Vec3f tangent = Vec3f::UnitX();  // ropes are made along x, so the first frame is rotated from x
  Vec3f side = Vec3f::UnitY();
  const auto turn_to = [&](const Vec3f& next) {
    if (next.isZero()) return;
    side = rotation_between(tangent.cast<double>(), next.cast<double>()).cast<float>() * side;
    tangent = next;
    side = (side - side.dot(tangent) * tangent).normalized();
  };
  const auto cap = [&](const Vec3f& centre, std::uint32_t ring, float sign, std::size_t at) {
    const float angle = static_cast<float>(M_PI_2) * static_cast<float>(ring) / cap_rings;
    lay_ring(centre, tangent, side, radius, std::sin(angle), sign * std::cos(angle), at, tube);
  };

  std::size_t ring = 0;
  turn_to(tangent_at(axis, 0));
  for (std::uint32_t c = 0; c < cap_rings; ++c) cap(axis.front(), c, -1, ring++);
  for (std::size_t i = 0; i < axis.size(); ++i) {
    turn_to(tangent_at(axis, i));
    lay_ring(axis[i], tangent, side, radius, 1, 0, ring++, tube);
  }
  for (std::uint32_t c = cap_rings; c-- > 0;) cap(axis.back(), c, 1, ring++);
}

}  // namespace prosector
