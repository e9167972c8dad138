#include "server/physics/mechanics/rigid/rolling.h"

#include <algorithm>
#include <cmath>

namespace prosector::rigid {
namespace {

constexpr double creep = 0.02;  // m/s of rolling, below which the offset decreases

}  // namespace

double rolling_lever(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal) {
  return a.resistance * std::max(0.0, normal.dot(a.middle - point)) +
         b.resistance * std::max(0.0, normal.dot(point - b.middle));
}

Vec3 rolling_lead(const RollingSide& a, const RollingSide& b, const Vec3& point, const Vec3& normal) {
  const double lever = rolling_lever(a, b, point, normal);
  if (lever == 0) return Vec3::Zero();
  const Vec3& middle = a.resistance > 0 ? a.middle : b.middle;
  const Vec3 ahead = (a.spin - b.spin).cross(normal) * std::abs(normal.dot(middle - point));  // m/s
  const double speed = ahead.norm();
  return speed > 0 ? Vec3(ahead / speed * lever * std::min(1.0, speed / creep)) : Vec3::Zero();
}

}  // namespace prosector::rigid
