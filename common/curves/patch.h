#pragma once
// Surface patches over 0 … 1 in u and v.

#include <array>
#include <memory>

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// A point on a surface, and the derivatives by u and v.
struct PatchPoint {
  Vec3 x = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero();
};

class Patch {
 public:
  virtual ~Patch() = default;
  /// Evaluates the surface at u and v in 0 … 1.
  virtual PatchPoint evaluate(double u, double v) const = 0;
  /// Returns the increasing parameters at which derivatives may be discontinuous, 0 and 1 included: first
  /// along u, then along v.
  virtual std::array<std::vector<double>, 2> seams() const = 0;
};

/// A tensor product of rational B-splines (Piegl & Tiller, The NURBS Book, 2nd ed. 1997, A4.4).
class NurbsSurface final : public Patch {
 public:
  struct Direction {
    int degree;
    std::vector<double> knots;
  };
  /// Takes `points` row by row, `columns` points along u in each row. Throws InputError as NurbsCurve does,
  /// naming `u` or `v`, and for points that don't fill whole rows.
  NurbsSurface(Direction u, Direction v, std::size_t columns, std::span<const Vec3> points,
               std::vector<double> weights = {});

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  std::array<Direction, 2> directions_;
  std::array<std::size_t, 2> counts_;
  std::vector<Eigen::Vector4d> points_;
};

/// Surface of revolution: a profile curve in the x-y plane, along v, rotated once about the y axis, along u
/// from x towards −z (Piegl & Tiller, 8.5).
class RevolvedPatch final : public Patch {
 public:
  /// Throws InputError for a curve that leaves the plane or crosses the axis.
  explicit RevolvedPatch(NurbsCurve profile);

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  NurbsCurve profile_;
};

/// Coons patch: the bilinearly blended surface between four curves (Coons 1967; Farin, Curves and Surfaces
/// for CAGD, 5th ed. 2002, ch. 22).
class CoonsPatch final : public Patch {
 public:
  /// Takes the sides along u at v = 0 and v = 1, then along v at u = 0 and u = 1. Throws InputError that
  /// names the corner if two sides are farther apart there than 1e-6 of their extent.
  explicit CoonsPatch(std::array<NurbsCurve, 4> sides);

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  std::array<NurbsCurve, 4> sides_;
};

}  // namespace prosector
