#include "server/physics/mechanics/contact/area_rule.h"

#include <array>
#include <cmath>

namespace prosector::contact {
namespace {

// Fractions of the area; exact for quadratic functions.
constexpr double at_corner = 1.0 / 12, at_middle = 3.0 / 4;
// Largest spacing of points, in radii of a round body; triangles with larger spacing are quartered. A body
// pressed in by a tenth of its radius touches over a third of it. The spacing is below two thirds of that.
constexpr double most_spacing = 0.2;
// Point spacing of `whole`, as a multiple of the square root of the area.
constexpr double spacing_of_whole = 0.8;

const std::array<AreaPoint, 1> on_whole = {{{Vec3::Constant(1.0 / 3), at_middle}}};

std::array<AreaPoint, 7> make_quarters() {
  std::array<AreaPoint, 7> out;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    // The midpoint of the opposite edge is a corner of three quarters.
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
  // A ball has twice the curvature of a rod of its radius, and a smaller contact area.
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

}  // namespace prosector::contact
