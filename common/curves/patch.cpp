#include "common/curves/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

/// Adds each distinct knot of the domain as a fraction of the domain.
void add_seams(std::span<const double> knots, double begin, double end, std::vector<double>& seams) {
  for (const double knot : knots)
    if (knot >= begin && knot <= end) seams.push_back((knot - begin) / (end - begin));
}

void sort_once(std::vector<double>& seams) {
  std::sort(seams.begin(), seams.end());
  seams.erase(std::unique(seams.begin(), seams.end()), seams.end());
}

/// Evaluates a side at a fraction of its domain; derivatives are by that fraction.
CurvePoint evaluate_fraction(const NurbsCurve& side, double share) {
  const double length = side.end() - side.begin();
  CurvePoint out = side.evaluate(side.begin() + share * length);
  out.first *= length;
  return out;
}

}  // namespace

NurbsSurface::NurbsSurface(Direction u, Direction v, std::size_t columns, std::span<const Vec3> points,
                           std::vector<double> weights)
    : directions_{std::move(u), std::move(v)} {
  check_points(points, weights);
  if (columns == 0 || points.size() % columns != 0)
    throw InputError(
        fmt::format("{} control points do not fill whole rows of {} columns", points.size(), columns));
  counts_ = {columns, points.size() / columns};
  for (const std::size_t k : {0U, 1U}) try {
      check_knots(directions_[k].knots, counts_[k], directions_[k].degree);
    } catch (const InputError& error) {
      throw InputError(fmt::format("along {}: {}", k == 0 ? 'u' : 'v', error.what()));
    }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 x = weights[k] * points[k];
    points_.emplace_back(x.x(), x.y(), x.z(), weights[k]);
  }
}

PatchPoint NurbsSurface::evaluate(double u, double v) const {
  std::array<std::size_t, 2> first{};
  std::array<BasisDerivatives, 2> basis;
  std::array<double, 2> length{};
  for (const std::size_t k : {0U, 1U}) {
    const auto& [degree, knots] = directions_[k];
    const double begin = knots[static_cast<std::size_t>(degree)];
    length[k] = knots[counts_[k]] - begin;
    const double at = begin + std::clamp(k == 0 ? u : v, 0.0, 1.0) * length[k];
    const std::size_t span = find_span(knots, counts_[k], degree, at);
    basis[k] = basis_derivatives(knots, span, degree, at);
    first[k] = span - static_cast<std::size_t>(degree);
  }
  Eigen::Vector4d s = Eigen::Vector4d::Zero(), su = s, sv = s;
  for (std::size_t j = 0; j <= static_cast<std::size_t>(directions_[1].degree); ++j)
    for (std::size_t i = 0; i <= static_cast<std::size_t>(directions_[0].degree); ++i) {
      const Eigen::Vector4d& p = points_[(first[1] + j) * counts_[0] + first[0] + i];
      s += basis[0].order[0][i] * basis[1].order[0][j] * p;
      su += basis[0].order[1][i] * basis[1].order[0][j] * p;
      sv += basis[0].order[0][i] * basis[1].order[1][j] * p;
    }
  PatchPoint out;
  out.x = projected(s);
  out.u = length[0] * (su.head<3>() - su.w() * out.x) / s.w();
  out.v = length[1] * (sv.head<3>() - sv.w() * out.x) / s.w();
  return out;
}

std::array<std::vector<double>, 2> NurbsSurface::seams() const {
  std::array<std::vector<double>, 2> out;
  for (const std::size_t k : {0U, 1U}) {
    const auto& [degree, knots] = directions_[k];
    add_seams(knots, knots[static_cast<std::size_t>(degree)], knots[counts_[k]], out[k]);
    sort_once(out[k]);
  }
  return out;
}

RevolvedPatch::RevolvedPatch(NurbsCurve profile) : profile_(std::move(profile)) {
  double extent = 0;
  for (const Eigen::Vector4d& point : profile_.points()) extent = std::max(extent, projected(point).norm());
  std::size_t k = 0;
  for (const Eigen::Vector4d& point : profile_.points()) {
    ++k;
    const Vec3 x = projected(point);
    if (std::abs(x.z()) > 1e-9 * extent || x.x() < -1e-9 * extent)
      throw InputError(
          fmt::format("point {} of the side is ({:.4g}, {:.4g}, {:.4g}): the profile of a revolved patch "
                      "must have x >= 0 and z = 0",
                      k, x.x(), x.y(), x.z()));
  }
}

PatchPoint RevolvedPatch::evaluate(double u, double v) const {
  const CurvePoint p = evaluate_fraction(profile_, v);
  const double c = std::cos(2 * M_PI * u), s = std::sin(2 * M_PI * u);
  const auto turned = [&](const Vec3& x) { return Vec3(x.x() * c, x.y(), -x.x() * s); };
  return {turned(p.x), 2 * M_PI * Vec3(-p.x.x() * s, 0, -p.x.x() * c), turned(p.first)};
}

std::array<std::vector<double>, 2> RevolvedPatch::seams() const {
  std::array<std::vector<double>, 2> out = {{{0, 0.25, 0.5, 0.75, 1}, {}}};
  add_seams(profile_.knots(), profile_.begin(), profile_.end(), out[1]);
  sort_once(out[1]);
  return out;
}

CoonsPatch::CoonsPatch(std::array<NurbsCurve, 4> sides) : sides_(std::move(sides)) {
  Eigen::AlignedBox3d box;
  for (const NurbsCurve& side : sides_)
    for (const Eigen::Vector4d& point : side.points()) box.extend(projected(point));
  for (const double u : {0.0, 1.0})
    for (const double v : {0.0, 1.0}) {
      const Vec3 along_u = evaluate_fraction(sides_[v > 0], u).x,
                 along_v = evaluate_fraction(sides_[2 + (u > 0)], v).x;
      if ((along_u - along_v).norm() <= 1e-6 * box.sizes().norm()) continue;
      throw InputError(
          fmt::format("sides {} and {} of a Coons patch are {:.3g} m apart at the corner u = {}, v = {}; "
                      "they must meet there",
                      v > 0 ? 2 : 1, u > 0 ? 4 : 3, (along_u - along_v).norm(), u, v));
    }
}

// Sum of the two ruled surfaces between opposite sides, minus the bilinear surface between the corners.
PatchPoint CoonsPatch::evaluate(double u, double v) const {
  const CurvePoint low = evaluate_fraction(sides_[0], u), high = evaluate_fraction(sides_[1], u);
  const CurvePoint left = evaluate_fraction(sides_[2], v), right = evaluate_fraction(sides_[3], v);
  const Vec3 a = evaluate_fraction(sides_[0], 0).x, b = evaluate_fraction(sides_[0], 1).x;
  const Vec3 c = evaluate_fraction(sides_[1], 0).x, d = evaluate_fraction(sides_[1], 1).x;
  PatchPoint out;
  out.x = (1 - v) * low.x + v * high.x + (1 - u) * left.x + u * right.x -
          ((1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d));
  out.u = (1 - v) * low.first + v * high.first + right.x - left.x - ((1 - v) * (b - a) + v * (d - c));
  out.v = high.x - low.x + (1 - u) * left.first + u * right.first - ((1 - u) * (c - a) + u * (d - b));
  return out;
}

std::array<std::vector<double>, 2> CoonsPatch::seams() const {
  std::array<std::vector<double>, 2> out;
  for (std::size_t k = 0; k < 4; ++k)
    add_seams(sides_[k].knots(), sides_[k].begin(), sides_[k].end(), out[k / 2]);
  for (std::vector<double>& seams : out) sort_once(seams);
  return out;
}

}  // namespace prosector
