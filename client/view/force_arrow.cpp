#include "client/view/force_arrow.h"

#include <algorithm>
#include <array>

namespace prosector {
namespace {

constexpr double per_newton = 0.02, longest = 0.15;  // m/N, m
constexpr double least_force = 0.05;                 // N
// Length and half-width of its head, per length.
constexpr double head = 0.25, spread = 0.12;
constexpr double head_width = 3, shaft_width = 4;  // points
const Vec3 arrow_color{1.0, 0.62, 0.12};

}  // namespace

void add_force_arrow(DrawList& list, const Vec3& point, const Vec3& force) {
  const double size = force.norm();
  if (!(size >= least_force)) return;
  const Vec3 along = force / size, across = along.unitOrthogonal(), other = along.cross(across);
  const double length = std::min(per_newton * size, longest);
  const Vec3 tip = point + length * along, neck = tip - head * length * along;
  const auto add = [&](const Vec3& from, double width) {
    list.lines.push_back({.a = from, .b = tip, .color = arrow_color, .width = width, .over = true});
  };
  add(point, shaft_width);
  for (const Vec3& side : std::array<Vec3, 4>{across, -across, other, -other})
    add(neck + spread * length * side, head_width);
}

}  // namespace prosector
