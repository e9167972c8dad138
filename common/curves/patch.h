#pragma once
// Pieces of surfaces over 0 … 1 in u and v.

#include <array>
#include <memory>

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// A place on a surface and its derivatives by u and v.
struct PatchPoint {
  Vec3 x = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero();
};

class Patch {
 public:
  virtual ~Patch() = default;
  /// Evaluates the surface at u and v in 0 … 1.
  virtual PatchPoint evaluate(double u, double v) const = 0;
  /// Returns where the derivatives may jump, 0 and 1 included, rising: along u, then along v.
  virtual std::array<std::vector<double>, 2> seams() const = 0;
};

/// A tensor product of rational B-splines (Piegl & Tiller, The NURBS Book, 2nd ed. 1997, A4.4).
class NurbsSurface final : public Patch {
 public:
  struct Direction {
    int degree;
    std::vector<double> knots;
  };
  /// Takes `points` row by row, as many along u as `columns`. Throws InputError as NurbsCurve does, and for
  /// points that don't fill their rows; `u` or `v` named.
  NurbsSurface(Direction u, Direction v, std::size_t columns, std::span<const Vec3> points,
               std::vector<double> weights = {});

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  std::array<Direction, 2> directions_;
  std::array<std::size_t, 2> counts_;
  std::vector<Eigen::Vector4d> points_;
};

/// A curve in the x-y plane, along v, turned once about the y axis, along u from x towards −z (Piegl &
/// Tiller, 8.5).
class RevolvedPatch final : public Patch {
 public:
  /// Throws InputError for a curve that leaves the plane or crosses the axis.
  explicit RevolvedPatch(NurbsCurve profile);

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  NurbsCurve profile_;
};

/// The bilinearly blended surface between four curves (Coons 1967; Farin, Curves and Surfaces for CAGD, 5th
/// ed. 2002, ch. 22).
class CoonsPatch final : public Patch {
 public:
  /// Takes the sides along u at v = 0 and v = 1, then along v at u = 0 and u = 1. Throws InputError naming
  /// the corner where two of them are farther apart than a millionth of their extent.
  explicit CoonsPatch(std::array<NurbsCurve, 4> sides);

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  std::array<NurbsCurve, 4> sides_;
};

}  // namespace prosector
