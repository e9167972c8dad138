#include "server/physics/panel/panel_place.h"

#include <algorithm>

#include "common/panel.h"

namespace prosector {
namespace {

constexpr double clearance = 0.03;  // m between part and panel
constexpr double farthest = 0.25;   // m from where it was touched to the panel's rim, however large the part
constexpr double steepest = 0.94;   // sine of the panel's inclination

/// The level direction from one place to another, or towards +z where there is none.
Vec3 level_direction(const Vec3& from, const Vec3& to) {
  const Vec3 way(to.x() - from.x(), 0, to.z() - from.z());
  return way.norm() > 1e-3 ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ());
}

}  // namespace

Pose place_panel(const PanelSite& site) {
  const Vec3 up = Vec3::UnitY();
  const Vec3 to_reader = level_direction(site.touched, site.reader);
  const Vec3 outward = site.side * up.cross(to_reader);
  double reach = 0;  // of the part beyond where it was touched
  for (const double x : {site.lo.x(), site.hi.x()})
    for (const double z : {site.lo.z(), site.hi.z()})
      reach = std::max(reach, outward.dot(Vec3(x, site.touched.y(), z) - site.touched));
  reach = std::min(reach + clearance, farthest);
  const Vec3 middle = site.touched + (reach + panel_width / 2) * outward + panel_height / 2 * up;

  const Vec3 ahead = level_direction(middle, site.reader);
  const double sine = std::clamp((site.reader - middle).stableNormalized().y(), -steepest, steepest);
  Mat3 axes;
  axes.col(2) = std::sqrt(1 - sine * sine) * ahead + sine * up;
  axes.col(0) = up.cross(ahead);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return {middle, Quat(axes).normalized()};
}

}  // namespace prosector
