#include "common/curves/flatten.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr int max_bisections = 40;  // of a span: beyond it, the parameter's precision is exhausted

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
  // If all legs are within half of `turn` of the chord, they are within `turn` of each other.
  const Vec3 chord = x.back() - x.front();
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const Vec3 leg = x[k + 1] - x[k];
    if (leg.isZero(0)) continue;
    if (std::atan2(leg.cross(chord).norm(), leg.dot(chord)) > turn / 2) return false;
  }
  return true;
}

void add(const BezierPiece& piece, double tolerance, double turn, int halvings, std::vector<double>& ends) {
  if (halvings < max_bisections && !is_flat(piece, tolerance, turn)) {
    for (const BezierPiece& half : piece.halves()) add(half, tolerance, turn, halvings + 1, ends);
    return;
  }
  ends.push_back(piece.to);
  if (ends.size() > max_polyline_points)
    throw InputError(
        fmt::format("a curve needs more than {} segments for a tolerance of {} m; increase the tolerance",
                    max_polyline_points, tolerance));
}

}  // namespace

std::vector<double> flatten(const NurbsCurve& curve, double tolerance, double turn) {
  std::vector<double> ends = {curve.begin()};
  for (const BezierPiece& piece : bezier_pieces(curve)) add(piece, tolerance, turn, 0, ends);
  return ends;
}

}  // namespace prosector
