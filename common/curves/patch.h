#pragma once
// Surface patches over 0 … 1 in u and v.

#include <array>
#include <memory>

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// A point on a surface patch, and the derivatives of the position by the parameters u and v.
struct PatchPoint {
  Vec3 x = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero();
};

class Patch {
 public:
  virtual ~Patch() = default;
  /// Returns the point and derivatives of the surface patch at the parameters u and v in 0 … 1.
  virtual PatchPoint evaluate(double u, double v) const = 0;
  /// Returns the parameters of the patch at which its derivatives may be discontinuous, increasing, 0 and 1
  /// included. The first list is along u, the second along v.
  virtual std::array<std::vector<double>, 2> seams() const = 0;
};

/// Surface patch that is a tensor product of rational B-splines (Piegl & Tiller, The NURBS Book, 2nd ed.
/// 1997, A4.4).
class NurbsSurface final : public Patch {
 public:
  struct Direction {
    int degree;
    std::vector<double> knots;
  };
  /// Makes a surface from its control points, row by row, with `columns` points along u in each row. Empty
  /// `weights` are all 1. Throws InputError as NurbsCurve does, naming `u` or `v`, and for points that don't
  /// fill whole rows.
  NurbsSurface(Direction u, Direction v, std::size_t columns, std::span<const Vec3> points,
               std::vector<double> weights = {});

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  std::array<Direction, 2> directions_;
  std::array<std::size_t, 2> counts_;
  std::vector<Eigen::Vector4d> points_;
};

/// Surface of revolution: a profile curve in the x-y plane is rotated once about the y axis. The parameter v
/// runs along the profile, and u along the rotation, from x towards −z (Piegl & Tiller, 8.5).
class RevolvedPatch final : public Patch {
 public:
  /// Makes the surface of revolution of a profile curve in the x-y plane about the y axis. Throws InputError
  /// for a curve that leaves the plane or crosses the axis.
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
  /// Makes the surface from its four sides: those along u at v = 0 and at v = 1, then those along v at u = 0
  /// and at u = 1. Throws InputError that names the corner if two sides are farther apart there than 1e-6 of
  /// their extent.
  explicit CoonsPatch(std::array<NurbsCurve, 4> sides);

  PatchPoint evaluate(double u, double v) const override;
  std::array<std::vector<double>, 2> seams() const override;

 private:
  std::array<NurbsCurve, 4> sides_;
};

}  // namespace prosector
