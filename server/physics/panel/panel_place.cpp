#include "server/physics/panel/panel_place.h"

#include <algorithm>
#include <cmath>

#include "common/panel.h"

namespace prosector {
namespace {

constexpr double clearance = 0.03;  // m between the part's top and the panel's lower rim
constexpr double highest = 0.25;    // m from where it was touched to the lower rim, however high the part
constexpr double aside = 0.12;   // m to the side of where it was touched, so that the arm hides little of it
constexpr double behind = 0.06;  // m beyond where it was touched
constexpr double around_head = 0.05;  // m from the head, within which a hand takes hold of it
constexpr double steepest = 0.94;     // sine of the panel's inclination
constexpr double from_above =
    0.85;  // sine of the gaze's inclination from which a reader looks down on the part

/// Returns the level direction from one place to another, or towards +z where there is none.
Vec3 level_direction(const Vec3& from, const Vec3& to) {
  const Vec3 way(to.x() - from.x(), 0, to.z() - from.z());
  return way.norm() > 1e-3 ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ());
}

/// Tells whether the reader looks at the part from above: what stands above it would hide it then.
bool is_from_above(const PanelSite& site) {
  return (site.reader - site.touched).stableNormalized().y() > from_above;
}

/// Returns how far the part's box reaches from where it was touched, along a level direction, m.
double reach_along(const PanelSite& site, const Vec3& way) {
  const double x = way.x() > 0 ? site.hi.x() - site.touched.x() : site.lo.x() - site.touched.x();
  const double z = way.z() > 0 ? site.hi.z() - site.touched.z() : site.lo.z() - site.touched.z();
  return std::max(way.x() * x + way.z() * z, 0.0);
}

}  // namespace

Pose place_panel(const PanelSite& site) {
  const Vec3 up = Vec3::UnitY();
  const Vec3 to_reader = level_direction(site.touched, site.reader);
  const Vec3 outward = site.side * up.cross(to_reader);
  const double top = std::min(std::max(site.hi.y() - site.touched.y(), 0.0) + clearance, highest);
  if (is_from_above(site)) {
    const double rim = std::min(reach_along(site, -to_reader) + clearance, highest);
    const Vec3 beyond = site.touched - (rim + panel_height / 2) * to_reader + top * up;
    return {beyond, face_reader(beyond, site.reader)};
  }
  const Vec3 middle = site.touched + aside * outward - behind * to_reader + (top + panel_height / 2) * up;
  return {middle, face_reader(middle, site.reader)};
}

bool is_at_head(const Vec3& at) {
  return std::abs(at.x()) < panel_width / 2 + around_head && std::abs(at.z()) < around_head &&
         at.y() > panel_head_bottom && at.y() < panel_height / 2 + around_head;
}

Quat face_reader(const Vec3& middle, const Vec3& reader) {
  const Vec3 up = Vec3::UnitY(), ahead = level_direction(middle, reader);
  const double sine = std::clamp((reader - middle).stableNormalized().y(), -steepest, steepest);
  Mat3 axes;
  axes.col(2) = std::sqrt(1 - sine * sine) * ahead + sine * up;
  axes.col(0) = up.cross(ahead);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes).normalized();
}

}  // namespace prosector
