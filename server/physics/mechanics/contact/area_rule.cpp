#include "server/physics/mechanics/contact/area_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace prosector::contact {
namespace {

// Fractions of the area; exact for quadratic functions.
constexpr double at_corner = 1.0 / 12, at_middle = 3.0 / 4;
// Largest spacing of points, in radii of a round body; triangles with larger spacing are quartered. A body
// pressed in by a tenth of its radius touches over a third of it. The spacing is below two thirds of that.
constexpr double most_spacing = 0.2;
// The same for quarters, which are quartered again.
constexpr double most_spacing_of_quarters = 0.3;
// Point spacing of `whole`, as a multiple of the square root of the area.
constexpr double spacing_of_whole = 0.8;

/// Returns the rule's points off the corners of a triangle whose edges are divided into `parts`. First come
/// the other corners of its parts, with the sums of their shares, then the parts' centroids.
std::vector<AreaPoint> points_of_parts(int parts) {
  std::vector<AreaPoint> corners, middles;
  const double each = 1.0 / (parts * parts), inside = 6;  // parts around an inner point
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) {
      const Vec3 at = Vec3(parts - i - j, i, j) / parts;
      const auto on_edges = (at.array() == 0).count();
      if (on_edges < 2) corners.push_back({at, (on_edges == 1 ? inside / 2 : inside) * at_corner * each});
      for (const double third : {1.0 / 3, 2.0 / 3}) {
        const Vec3 middle = Vec3(parts - i - j - 2 * third, i + third, j + third) / parts;
        if (middle.minCoeff() > 0) middles.push_back({middle, at_middle * each});
      }
    }
  corners.insert(corners.end(), middles.begin(), middles.end());
  return corners;
}

const std::vector<AreaPoint>& points_under(Division division) {
  static const std::array<std::vector<AreaPoint>, 4> points = {std::vector<AreaPoint>{}, points_of_parts(1),
                                                               points_of_parts(2), points_of_parts(4)};
  return points[static_cast<std::size_t>(division)];
}

}  // namespace

Division division_for(double area, double curvature, bool quadratic) {
  if (curvature == 0 && !quadratic) return Division::corners;
  // A ball has twice the curvature of a rod of its radius, and a smaller contact area.
  const double spacing = spacing_of_whole * std::sqrt(area) * curvature / 2;
  if (spacing <= most_spacing) return Division::whole;
  return spacing / 2 <= most_spacing_of_quarters ? Division::quarters : Division::sixteenths;
}

double corner_share(Division division) {
  if (division == Division::corners) return 1.0 / 3;
  const double parts = division == Division::whole ? 1 : division == Division::quarters ? 4 : 16;
  return at_corner / parts;
}

std::span<const AreaPoint> face_points(Division division) {
  return points_under(division);
}

std::uint32_t first_face_point(Division division) {
  std::size_t before = 0;
  for (const Division coarser : {Division::whole, Division::quarters})
    if (coarser < division) before += points_under(coarser).size();
  return static_cast<std::uint32_t>(before);
}

std::span<const Vec3> places_on_quarters() {
  static const std::vector<Vec3> places = [] {
    std::vector<Vec3> out;
    for (const AreaPoint& point : face_points(Division::quarters)) out.push_back(point.weights);
    std::stable_partition(out.begin(), out.end(),
                          [](const Vec3& w) { return !w.isApproxToConstant(1.0 / 3); });
    return out;
  }();
  return places;
}

}  // namespace prosector::contact
