#include "server/physics/mechanics/panel/panel_place.h"

#include <algorithm>
#include <cmath>

#include "common/panel.h"

namespace prosector::panel {
namespace {

constexpr double clearance = 0.03;  // m, between the part's top and the panel's lower rim
constexpr double highest = 0.25;    // m: largest height of the lower rim above the touched point
// m: sideways offset from the touched point, so that the arm hides little of the panel.
constexpr double aside = 0.12;
constexpr double behind = 0.06;       // m: offset beyond the touched point
constexpr double around_head = 0.05;  // m: distance from the head within which hands grasp it
constexpr double steepest = 0.94;     // sine of the panel's largest inclination

// Sines of the inclination of a reader's gaze at a point.
constexpr double steep = 0.7;  // above this, the reader's facing direction counts increasingly
// Above this, only the facing direction counts: the reader looks down on the point.
constexpr double from_above = 0.85;

double inclination_of_gaze(const Vec3& place, const PanelReader& reader) {
  return (reader.eyes - place).stableNormalized().y();
}

/// Returns the horizontal unit vector from `place` towards the reader, or +z if undefined. For a reader above
/// the place, it is opposite to the reader's facing direction, since the reader's horizontal position then
/// does not determine which direction is up in the view.
Vec3 towards_reader(const Vec3& place, const PanelReader& reader) {
  const Vec3 way(reader.eyes.x() - place.x(), 0, reader.eyes.z() - place.z());
  const Vec3 level = way.norm() > 1e-3 ? Vec3(way.normalized()) : Vec3::Zero();
  const double share =
      std::clamp((inclination_of_gaze(place, reader) - steep) / (from_above - steep), 0.0, 1.0);
  const bool faces = !reader.ahead.isZero();
  const Vec3 sum = faces ? Vec3((1 - share) * level - share * reader.ahead) : level;
  return sum.norm() > 1e-3 ? Vec3(sum.normalized()) : faces ? Vec3(-reader.ahead) : Vec3(Vec3::UnitZ());
}

/// Returns whether the reader looks at the part from above. A panel above the part would then hide it.
bool is_from_above(const PanelSite& site) {
  return inclination_of_gaze(site.touched, site.reader) > from_above;
}

/// Returns how far the part's box extends from the touched point along a horizontal direction, m.
double reach_along(const PanelSite& site, const Vec3& way) {
  const double x = way.x() > 0 ? site.hi.x() - site.touched.x() : site.lo.x() - site.touched.x();
  const double z = way.z() > 0 ? site.hi.z() - site.touched.z() : site.lo.z() - site.touched.z();
  return std::max(way.x() * x + way.z() * z, 0.0);
}

}  // namespace

Pose place_panel(const PanelSite& site) {
  const Vec3 up = Vec3::UnitY();
  const Vec3 to_reader = towards_reader(site.touched, site.reader);
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

Quat face_reader(const Vec3& middle, const PanelReader& reader) {
  const Vec3 up = Vec3::UnitY(), ahead = towards_reader(middle, reader);
  const double sine = std::clamp(inclination_of_gaze(middle, reader), -steepest, steepest);
  Mat3 axes;
  axes.col(2) = std::sqrt(1 - sine * sine) * ahead + sine * up;
  axes.col(0) = up.cross(ahead);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes).normalized();
}

}  // namespace prosector::panel
