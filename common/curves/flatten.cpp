#include "common/curves/flatten.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr int most_halvings = 40;  // of a span: beyond them its parameter has no digits left

double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp(along.dot(x - a) / squared, 0.0, 1.0) : 0;
  return (x - a - share * along).norm();
}

bool is_flat(const BezierPiece& piece, double tolerance, double turn) {
  std::vector<Vec3> x;
  for (const Eigen::Vector4d& point : piece.points) x.push_back(projected(point));
  for (const Vec3& point : x)
    if (distance_to_segment(point, x.front(), x.back()) > tolerance) return false;
  // Legs within half the turn of the chord are within the turn of each other.
  const Vec3 chord = x.back() - x.front();
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const Vec3 leg = x[k + 1] - x[k];
    if (leg.isZero(0)) continue;
    if (std::atan2(leg.cross(chord).norm(), leg.dot(chord)) > turn / 2) return false;
  }
  return true;
}

void add(const BezierPiece& piece, double tolerance, double turn, int halvings, std::vector<double>& ends) {
  if (halvings < most_halvings && !is_flat(piece, tolerance, turn)) {
    for (const BezierPiece& half : piece.halves()) add(half, tolerance, turn, halvings + 1, ends);
    return;
  }
  ends.push_back(piece.to);
  if (ends.size() > max_polygon)
    throw InputError(fmt::format("a curve of more than {} pieces within {} m; allow a larger tolerance",
                                 max_polygon, tolerance));
}

}  // namespace

std::vector<double> flatten(const NurbsCurve& curve, double tolerance, double turn) {
  std::vector<double> ends = {curve.begin()};
  for (const BezierPiece& piece : bezier_pieces(curve)) add(piece, tolerance, turn, 0, ends);
  return ends;
}

}  // namespace prosector
