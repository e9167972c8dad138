#include "client/view/draped_line.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double spacing = 0.006;      // m
constexpr double height = 0.02;        // m, over the surface: origin of the rays
constexpr double deepest = 0.04;       // m: largest distance from a ray's origin to the same surface
constexpr double off_surface = 0.001;  // m

/// Adds points from `point` on along the surface, up to `length` or the surface's end.
void add_places(const FindSurface& find, const Picked& point, const Vec3& way, double length,
                std::vector<Vec3>& out) {
  Vec3 at = point.at, normal = point.normal;
  for (double gone = 0; gone < length - 1e-9; gone += spacing) {
    const double step = std::min(spacing, length - gone);
    const Vec3 level = (way - way.dot(normal) * normal).normalized();
    const Vec3 over = at + step * level + height * normal;
    const auto next = level.allFinite() ? find({over, -normal}, point.body) : std::nullopt;
    if (!next || next->distance > deepest) return;
    at = next->at;
    normal = (normal + next->normal).normalized();
    out.push_back(at + off_surface * normal);
  }
}

}  // namespace

std::vector<Vec3> draped_line(const FindSurface& find, const Picked& point, const Vec3& along, double behind,
                              double ahead) {
  std::vector<Vec3> out;
  add_places(find, point, -along, behind, out);
  std::reverse(out.begin(), out.end());
  out.push_back(point.at + off_surface * point.normal);
  add_places(find, point, along, ahead, out);
  return out;
}

}  // namespace prosector
