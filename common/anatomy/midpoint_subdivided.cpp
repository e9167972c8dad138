#include "common/anatomy/midpoint_subdivided.h"

#include <algorithm>
#include <map>

namespace prosector {

TriangleMesh midpoint_subdivided(TriangleMesh surface) {
  std::vector<Vec3>& positions = surface.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, fresh] = middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions.size()));
    if (fresh) positions.emplace_back((positions[a] + positions[b]) / 2);
    return at->second;
  };
  std::vector<std::array<std::uint32_t, 3>> quarters;
  quarters.reserve(4 * surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    quarters.insert(quarters.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  surface.triangles = std::move(quarters);
  return surface;
}

}  // namespace prosector
