#include "server/physics/contact/area_rule.h"

#include <array>
#include <cmath>

namespace prosector {
namespace {

constexpr double at_corner = 1.0 / 12, at_middle = 3.0 / 4;  // of the area: exact for quadratic functions
// Points are no farther apart than this, in radii of a round thing, or triangles are quartered. Pressed in by
// a tenth of its radius it touches over a third of it: points are nearer than two thirds of that.
constexpr double most_spacing = 0.2;
constexpr double spacing_of_whole = 0.8;  // roots of the area

const std::array<AreaPoint, 1> on_whole = {{{Vec3::Constant(1.0 / 3), at_middle}}};

std::array<AreaPoint, 7> make_quarters() {
  std::array<AreaPoint, 7> out;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    // The middle of the edge across is a corner of three quarters.
    out[i] = {(Vec3::Ones() - Vec3::Unit(k)) / 2, 3 * at_corner / 4};
    out[3 + i] = {Vec3::Constant(1.0 / 6) + Vec3::Unit(k) / 2, at_middle / 4};
  }
  out[6] = {Vec3::Constant(1.0 / 3), at_middle / 4};
  return out;
}

const std::array<AreaPoint, 7>& on_quarters() {
  static const std::array<AreaPoint, 7> points = make_quarters();
  return points;
}

}  // namespace

Division division_for(double area, double curvature, bool quadratic) {
  if (curvature == 0 && !quadratic) return Division::corners;
  // A ball's curvature is twice that of a rod of its radius, and it presses a smaller spot.
  return spacing_of_whole * std::sqrt(area) * curvature / 2 > most_spacing ? Division::quarters
                                                                           : Division::whole;
}

double corner_share(Division division) {
  if (division == Division::corners) return 1.0 / 3;
  return division == Division::whole ? at_corner : at_corner / 4;
}

std::span<const AreaPoint> face_points(Division division) {
  if (division == Division::corners) return {};
  return division == Division::whole ? std::span<const AreaPoint>(on_whole) : on_quarters();
}

std::uint32_t first_face_point(Division division) {
  return division == Division::quarters ? 1 : 0;
}

std::span<const Vec3> places_on_quarters() {
  static const std::array<Vec3, 7> places = [] {
    std::array<Vec3, 7> out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = on_quarters()[i].weights;
    return out;
  }();
  return places;
}

}  // namespace prosector
