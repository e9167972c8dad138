#include "tests/collision/reference/self_contact.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/collision/primitives/triangle_crossing.h"
#include "server/physics/mechanics/collision/surface/surface_pairs.h"

namespace prosector {
namespace {

bool share_vertex(const collision::SurfaceTopology::Corners& a,
                  const collision::SurfaceTopology::Corners& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t v) { return v == b[0] || v == b[1] || v == b[2]; });
}

}  // namespace

std::vector<SelfContact> self_contacts(const collision::TriangleSurface& surface, double margin,
                                       std::span<const Vec3> rest) {
  const auto triangles = surface.topology().triangles();
  const double squared = margin * margin;
  const auto near_at_rest = [&](std::uint32_t s, std::uint32_t t) {
    if (rest.empty()) return false;
    const auto at_rest = [&](std::uint32_t i) {
      return collision::Triangle{rest[triangles[i][0]], rest[triangles[i][1]], rest[triangles[i][2]]};
    };
    return collision::closest(at_rest(s), at_rest(t)).squared_distance < squared;
  };
  std::vector<SelfContact> out;
  collision::descend_pairs(
      surface.tree(), surface.tree(), Mat3::Identity(), Vec3::Zero(), [&] { return squared; },
      [&](const collision::SurfaceTree::Node& p, const collision::SurfaceTree::Node& q) {
        if (p.begin > q.begin) return;  // comes the other way round
        for (std::uint32_t i = p.begin; i < p.end; ++i)
          for (std::uint32_t j = q.begin; j < q.end; ++j) {
            if (p.begin == q.begin && j <= i) continue;
            const auto [s, t] = std::minmax(surface.tree().order()[i], surface.tree().order()[j]);
            if (share_vertex(triangles[s], triangles[t])) continue;
            const collision::Triangle a = surface.triangle(s), b = surface.triangle(t);
            collision::TrianglePair pair = collision::closest(a, b);
            const collision::TriangleCrossing crosses = collision::crossing(a, b);
            if (crosses.count > 0) {
              const Vec3& x = crosses.piercings[0].point;
              pair = {collision::closest_weights(x, a[0], a[1], a[2]),
                      collision::closest_weights(x, b[0], b[1], b[2]), x, x, 0};
            }
            if (!(pair.squared_distance < squared) || near_at_rest(s, t)) continue;
            out.push_back({s, t, pair.weights_a, pair.weights_b, pair.on_a, pair.on_b,
                           std::sqrt(pair.squared_distance)});
          }
      });
  std::sort(out.begin(), out.end(), [](const SelfContact& a, const SelfContact& b) {
    return std::pair{a.triangle_a, a.triangle_b} < std::pair{b.triangle_a, b.triangle_b};
  });
  return out;
}

}  // namespace prosector
