#include "common/curves/nurbs_curve.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {

void check_points(std::span<const Vec3> points, std::vector<double>& weights) {
  if (points.size() > max_control_points)
    throw InputError(fmt::format("a curve or patch has {} control points: at most {} are allowed",
                                 points.size(), max_control_points));
  if (weights.empty()) weights.assign(points.size(), 1.0);
  if (weights.size() != points.size())
    throw InputError(
        fmt::format("{} weights are given for {} control points: give one for each point, or none",
                    weights.size(), points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_finite(points[k])) throw InputError(fmt::format("point {} is not finite", k + 1));
    if (!std::isfinite(weights[k]) || !(weights[k] > 0))
      throw InputError(fmt::format("weight {} is {}: must be above 0 and finite", k + 1, weights[k]));
  }
}

NurbsCurve::NurbsCurve(int degree, std::vector<double> knots, std::vector<Vec3> points,
                       std::vector<double> weights)
    : degree_(degree), knots_(std::move(knots)) {
  check_points(points, weights);
  check_knots(knots_, points.size(), degree);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 x = weights[k] * points[k];
    points_.emplace_back(x.x(), x.y(), x.z(), weights[k]);
  }
}

NurbsCurve NurbsCurve::bezier(std::vector<Vec3> points, std::vector<double> weights) {
  if (points.size() < 2 || points.size() > max_degree + 1)
    throw InputError(
        fmt::format("a bezier curve has {} points: it must have 2 to {}", points.size(), max_degree + 1));
  const int degree = static_cast<int>(points.size()) - 1;
  return {degree, bezier_knots(degree), std::move(points), std::move(weights)};
}

CurvePoint NurbsCurve::evaluate(double u) const {
  u = std::clamp(u, begin(), end());
  const std::size_t span = find_span(knots_, points_.size(), degree_, u);
  const BasisDerivatives n = basis_derivatives(knots_, span, degree_, u);
  std::array<Eigen::Vector4d, 3> a;
  for (std::size_t order = 0; order < 3; ++order) {
    a[order].setZero();
    for (std::size_t k = 0; k <= static_cast<std::size_t>(degree_); ++k)
      a[order] += n.order[order][k] * points_[span - static_cast<std::size_t>(degree_) + k];
  }
  // Quotient rule (A4.2).
  CurvePoint out;
  out.x = a[0].head<3>() / a[0].w();
  out.first = (a[1].head<3>() - a[1].w() * out.x) / a[0].w();
  out.second = (a[2].head<3>() - 2 * a[1].w() * out.first - a[2].w() * out.x) / a[0].w();
  return out;
}

NurbsCurve NurbsCurve::with_knot(double u) const {
  const auto p = static_cast<std::size_t>(degree_);
  const std::size_t span = find_span(knots_, points_.size(), degree_, u);
  NurbsCurve out;
  out.degree_ = degree_;
  out.knots_ = knots_;
  out.knots_.insert(out.knots_.begin() + static_cast<std::ptrdiff_t>(span) + 1, u);
  for (std::size_t i = 0; i <= points_.size(); ++i) {
    if (i <= span - p) {
      out.points_.push_back(points_[i]);
    } else if (i > span) {
      out.points_.push_back(points_[i - 1]);
    } else {
      const double length = knots_[i + p] - knots_[i];
      const double share = length > 0 ? (u - knots_[i]) / length : 0;
      out.points_.push_back(share * points_[i] + (1 - share) * points_[i - 1]);
    }
  }
  return out;
}

NurbsCurve NurbsCurve::moved(const Pose& pose) const {
  NurbsCurve out = *this;
  for (Eigen::Vector4d& point : out.points_) point.head<3>() = point.w() * (pose * projected(point));
  return out;
}

Vec3 BezierPiece::at(double s) const {
  std::vector<Eigen::Vector4d> b = points;
  for (std::size_t left = b.size() - 1; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k) b[k] = (1 - s) * b[k] + s * b[k + 1];
  return projected(b.front());
}

std::array<BezierPiece, 2> BezierPiece::halves() const {
  const double middle = (from + to) / 2;
  std::array<BezierPiece, 2> out = {BezierPiece{points, from, middle}, BezierPiece{points, middle, to}};
  std::vector<Eigen::Vector4d>& b = out[1].points;
  const std::size_t n = points.size();
  for (std::size_t left = n - 1; left > 0; --left) {
    for (std::size_t k = 0; k < left; ++k) b[k] = (b[k] + b[k + 1]) / 2;
    out[0].points[n - left] = b[0];
  }
  return out;
}

std::vector<BezierPiece> bezier_pieces(const NurbsCurve& curve) {
  const auto p = static_cast<std::size_t>(curve.degree());
  NurbsCurve whole = curve;
  std::vector<double> ends;  // ends of the non-empty spans
  for (const double u : curve.knots())
    if (u >= curve.begin() && u <= curve.end() && (ends.empty() || u > ends.back())) ends.push_back(u);
  for (const double u : ends)
    while (static_cast<std::size_t>(std::ranges::count(whole.knots(), u)) < p) whole = whole.with_knot(u);
  std::vector<BezierPiece> out;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const std::size_t span = find_span(whole.knots(), whole.points().size(), whole.degree(), ends[k]);
    const auto first = whole.points().begin() + static_cast<std::ptrdiff_t>(span - p);
    out.push_back({{first, first + static_cast<std::ptrdiff_t>(p) + 1}, ends[k], ends[k + 1]});
  }
  return out;
}

}  // namespace prosector
