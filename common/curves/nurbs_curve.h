#pragma once
// Rational B-spline curves (NURBS), which include Bézier curves and all conics (Piegl & Tiller, The NURBS
// Book, 2nd ed. 1997, ch. 4; Farin, Curves and Surfaces for CAGD, 5th ed. 2002).

#include <span>
#include <vector>

#include "common/curves/basis.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_control_points = 4096;

/// A point on a curve, and the first and second derivatives of the position by the curve's parameter.
struct CurvePoint {
  Vec3 x = Vec3::Zero();
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();
};

class NurbsCurve {
 public:
  /// Makes a curve from its degree, knots, control points and weights: one weight per point, or none (all are
  /// 1). Throws InputError for points or weights that aren't finite, weights that aren't positive, a wrong
  /// number of weights, and knots that check_knots() refuses.
  NurbsCurve(int degree, std::vector<double> knots, std::vector<Vec3> points,
             std::vector<double> weights = {});

  static NurbsCurve bezier(std::vector<Vec3> points, std::vector<double> weights = {});

  int degree() const { return degree_; }
  std::span<const double> knots() const { return knots_; }
  /// Returns the curve's control points in homogeneous coordinates: (w x, w y, w z, w), with the weight w.
  std::span<const Eigen::Vector4d> points() const { return points_; }
  double begin() const { return knots_[static_cast<std::size_t>(degree_)]; }
  double end() const { return knots_[points_.size()]; }

  /// Returns the curve's point at parameter `u`, clamped to begin() … end().
  Vec3 at(double u) const { return evaluate(u).x; }
  CurvePoint evaluate(double u) const;

  /// Returns a curve of the same shape with one more knot, inserted at the parameter `u` (Boehm 1980; The
  /// NURBS Book, A5.1). `u` must be inside the domain.
  NurbsCurve with_knot(double u) const;
  NurbsCurve moved(const Pose& pose) const;

 private:
  NurbsCurve() = default;

  int degree_ = 1;
  std::vector<double> knots_;
  std::vector<Eigen::Vector4d> points_;
};

/// A rational Bézier segment of a curve, for the curve's parameters from `from` to `to`.
struct BezierPiece {
  std::vector<Eigen::Vector4d> points;  // homogeneous
  double from = 0, to = 1;

  /// Returns the point of the Bézier segment at the fraction s (0 … 1) of its parameter range, by de
  /// Casteljau's algorithm.
  Vec3 at(double s) const;
  /// Returns the two halves of the Bézier segment, divided at the middle of its parameter range by de
  /// Casteljau's algorithm.
  std::array<BezierPiece, 2> halves() const;
};

/// Returns the curve's non-empty knot spans as Bézier segments, in order.
std::vector<BezierPiece> bezier_pieces(const NurbsCurve& curve);

inline Vec3 projected(const Eigen::Vector4d& homogeneous) {
  return homogeneous.head<3>() / homogeneous.w();
}

/// Checks the control points and weights of a curve or surface; fills empty `weights` with ones. Throws
/// InputError for values that aren't finite, weights that aren't positive, and a wrong number of weights.
void check_points(std::span<const Vec3> points, std::vector<double>& weights);

}  // namespace prosector
