#include "common/curves/tube.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/curves/flatten.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr double pi = M_PI;
constexpr int least_sides = 8, most_sides = 256;
constexpr double widest_turn = pi / 6;  // rad between two rings, for any tube diameter
constexpr std::size_t most_vertices = 1000 * 1000;

/// Returns half the angle of a chord whose distance to a circle of `radius` is at most `error`.
double half_angle(double radius, double error) {
  return std::acos(std::clamp(1 - error / radius, 0.0, 1.0));
}

/// Distinct positions along a curve, and its unit tangents there.
struct Axis {
  std::vector<Vec3> places, tangents;
  bool closed = false;
};

Axis axis_of(const NurbsCurve& curve, double tolerance, double turn) {
  Axis out;
  std::vector<CurvePoint> points;
  double extent = 0;
  for (const double u : flatten(curve, tolerance, turn)) {
    points.push_back(curve.evaluate(u));
    extent = std::max(extent, (points.back().x - points.front().x).norm());
  }
  if (!(extent > 0)) throw InputError("a curve without length");
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3& x = points[k].x;
    if (!out.places.empty() && (x - out.places.back()).norm() <= 1e-9 * extent) continue;
    // Where control points coincide, the derivative is zero: use the difference of the neighbouring points.
    const Vec3 ahead = points[std::min(k + 1, points.size() - 1)].x - points[k > 0 ? k - 1 : 0].x;
    const bool still = points[k].first.norm() <= 1e-9 * extent;
    out.places.push_back(x);
    out.tangents.push_back((still ? ahead : points[k].first).normalized());
  }
  out.closed = out.places.size() > 3 && (out.places.back() - out.places.front()).norm() <= 1e-6 * extent &&
               out.tangents.back().dot(out.tangents.front()) > std::cos(1e-3);
  return out;
}

Vec3 any_across(const Vec3& tangent) {
  Vec3::Index least = 0;
  tangent.cwiseAbs().minCoeff(&least);
  return tangent.cross(Vec3::Unit(least)).normalized();
}

/// Rotates the sides by an angle that grows along a ring, so that the last side equals the first.
void close_frames(const Axis& axis, std::vector<Vec3>& sides) {
  const Vec3& tangent = axis.tangents.front();
  const double off =
      std::atan2(sides.back().cross(sides.front()).dot(tangent), sides.back().dot(sides.front()));
  double length = 0;
  std::vector<double> at = {0};
  for (std::size_t k = 1; k < sides.size(); ++k)
    at.push_back(length += (axis.places[k] - axis.places[k - 1]).norm());
  for (std::size_t k = 0; k < sides.size(); ++k)
    sides[k] = Eigen::AngleAxisd(off * at[k] / length, axis.tangents[k]) * sides[k];
}

}  // namespace

std::vector<Vec3> rotation_minimising_sides(std::span<const Vec3> places, std::span<const Vec3> tangents,
                                            const Vec3& first) {
  std::vector<Vec3> out = {first};
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    // Reflect in the bisector plane to the next position, then in the plane that maps the tangent to the one
    // there.
    const Vec3 v1 = places[k + 1] - places[k];
    const double c1 = v1.squaredNorm();
    const Vec3 side = out[k] - (2 / c1) * v1.dot(out[k]) * v1;
    const Vec3 tangent = tangents[k] - (2 / c1) * v1.dot(tangents[k]) * v1;
    const Vec3 v2 = tangents[k + 1] - tangent;
    const double c2 = v2.squaredNorm();
    const Vec3 next = c2 > 0 ? Vec3(side - (2 / c2) * v2.dot(side) * v2) : side;
    out.push_back((next - next.dot(tangents[k + 1]) * tangents[k + 1]).normalized());
  }
  return out;
}

TriangleMesh tube_around(const NurbsCurve& curve, double diameter, double tolerance) {
  // A third of the tolerance each for: the axis, the turn along a segment, and the circumference.
  const double radius = diameter / 2, share = tolerance / 3;
  const double turn = std::min(widest_turn, 2 * half_angle(radius, share));
  Axis axis = axis_of(curve, share, turn);
  const auto sides = static_cast<std::uint32_t>(
      std::clamp(std::ceil(pi / half_angle(radius, share)), 1.0 * least_sides, 1.0 * most_sides));
  if (axis.places.size() * sides > most_vertices)
    throw InputError(fmt::format("a tube needs {} vertices for a tolerance of {} m; increase the tolerance",
                                 axis.places.size() * sides, tolerance));
  std::vector<Vec3> across =
      rotation_minimising_sides(axis.places, axis.tangents, any_across(axis.tangents.front()));
  if (axis.closed) close_frames(axis, across);
  const auto rings = static_cast<std::uint32_t>(axis.places.size()) - (axis.closed ? 1 : 0);

  TriangleMesh out;
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double angle = 2 * pi * s / sides;
      const Vec3 other = axis.tangents[r].cross(across[r]);
      out.positions.push_back(axis.places[r] +
                              radius * (std::cos(angle) * across[r] + std::sin(angle) * other));
    }
  const auto at = [&](std::uint32_t ring, std::uint32_t side) { return ring % rings * sides + side % sides; };
  for (std::uint32_t r = 0; r + (axis.closed ? 0 : 1) < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      out.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      out.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
  if (axis.closed) return out;
  const std::uint32_t begin = rings * sides, end = begin + 1;
  out.positions.push_back(axis.places.front());
  out.positions.push_back(axis.places.back());
  for (std::uint32_t s = 0; s < sides; ++s) {
    out.triangles.push_back({begin, at(0, s + 1), at(0, s)});
    out.triangles.push_back({end, at(rings - 1, s), at(rings - 1, s + 1)});
  }
  return out;
}

std::vector<Vec3> equidistant_points(const NurbsCurve& curve, double length) {
  // Arc lengths along a fine polyline, whose length is at most a thousandth shorter than the curve.
  const std::vector<double> fine = flatten(curve, length / 20, 0.1);
  std::vector<double> at = {0};
  std::vector<Vec3> places = {curve.at(fine.front())};
  for (std::size_t k = 1; k < fine.size(); ++k) {
    places.push_back(curve.at(fine[k]));
    at.push_back(at.back() + (places[k] - places[k - 1]).norm());
  }
  if (!(at.back() > 0)) throw InputError("a curve without length");
  const auto pieces = static_cast<std::size_t>(std::clamp(std::round(at.back() / length), 1.0, 1000.0));
  std::vector<Vec3> out;
  for (std::size_t k = 0, piece = 0; k <= pieces; ++k) {
    const double wanted = at.back() * static_cast<double>(k) / static_cast<double>(pieces);
    while (piece + 2 < at.size() && at[piece + 1] < wanted) ++piece;
    const double span = at[piece + 1] - at[piece];
    const double share = span > 0 ? std::clamp((wanted - at[piece]) / span, 0.0, 1.0) : 0;
    out.push_back(curve.at(fine[piece] + share * (fine[piece + 1] - fine[piece])));
  }
  return out;
}

}  // namespace prosector
