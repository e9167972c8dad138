#include "client/app/desk/blade_carry.h"

#include <algorithm>
#include <limits>

#include "client/app/desk/cut_drawing.h"

namespace prosector {
namespace {

constexpr double upright_speed = 2;  // rad/s
constexpr double travel_clearance = 0.025, rotation_clearance = 0.12,
                 probe_height = 0.3;  // m: clearance of a blade's tip above tissue, clearance while it
                                      // rotates, start height of the rays

/// Returns the height, m, of the highest surface in the next `far` m from `from` along the horizontal vector
/// `level`; −∞ if there is none.
double highest_ahead(const FindSurface& find, const Vec3& from, const Vec3& level, double far) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const double share : {0.0, 0.5, 1.0}) {
    const Vec3 over =
        from + (level.norm() > 0 ? share * far / level.norm() : 0) * level + probe_height * Vec3::UnitY();
    if (const auto below = find({over, -Vec3::UnitY()}, std::nullopt))
      highest = std::max(highest, below->at.y());
  }
  return highest;
}

}  // namespace

void BladeCarry::set_upright(const HandGuide& guide, const Vec3& target, DeskWrist& wrist, double seconds) {
  const Vec3 right = Vec3(guide.right.x(), 0, guide.right.z()).normalized();
  const bool is_up = guide.physical && (guide.physical->p - target).norm() < physical_tolerance;
  if (!right.allFinite() || over_ground_ < rotation_clearance - physical_tolerance || !is_up) return;
  upright_ = wrist.rotate_towards(blade_rotation(*guide.blade, Vec3::UnitY(), right),
                                  upright_speed * std::min(seconds, longest_step));
}

Vec3 BladeCarry::over_tissue(const HandGuide& guide, const Vec3& from, const Vec3& to, bool pressed) {
  const Vec3 level(to.x() - from.x(), 0, to.z() - from.z());
  const double far = std::min(level.norm(), lookahead_distance);
  const double highest = highest_ahead(guide.find, from, level, far);
  over_ground_ = from.y() - highest;
  const double needed = highest + (upright_ || pressed ? travel_clearance : rotation_clearance);
  if (from.y() < needed - target_tolerance) return {from.x(), needed, from.z()};
  Vec3 ahead = from + (level.norm() > far ? far / level.norm() : 1) *
                          (to - from);  // limited to the distance that was checked
  ahead.y() = std::max(ahead.y(), needed);
  return ahead;
}

}  // namespace prosector
