#include "server/physics/mechanics/contact/signed_distance.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/contact/grid_distance.h"

namespace prosector::contact {
namespace {

/// Returns the distance to a surface that is curved in `directions` (1 or 2) directions. `d`: vector from its
/// centre or axis to the point.
Distance from_center(const Vec3& d, double radius, int directions) {
  const double length = d.norm();
  return {length - radius, length > 0 ? Vec3(d / length) : Vec3(Vec3::UnitY()), directions / radius};
}

class CapsuleDistance final : public SignedDistance {  // a sphere is a capsule of length 0
 public:
  CapsuleDistance(double radius, double half) : radius_(radius), half_(half) {}
  Distance at(const Vec3& x) const override {
    const double at = std::clamp(x.y(), -half_, half_);
    return from_center({x.x(), x.y() - at, x.z()}, radius_, at == x.y() && half_ > 0 ? 1 : 2);
  }

 private:
  double radius_, half_;
};

class BoxDistance final : public SignedDistance {
 public:
  explicit BoxDistance(const Vec3& half) : half_(half) {}
  Distance at(const Vec3& x) const override {
    const Vec3 q = x.cwiseAbs() - half_;
    const Vec3 outside = q.cwiseMax(0);
    const auto signed_as = [&](const Vec3& v) { return Vec3((x.array() < 0).select(-v, v)); };
    if (const double d = outside.norm(); d > 0) return {d, signed_as(outside / d)};
    Eigen::Index axis;
    const double depth = q.maxCoeff(&axis);
    return {depth, signed_as(Vec3::Unit(axis))};
  }

 private:
  Vec3 half_;
};

class CylinderDistance final : public SignedDistance {
 public:
  CylinderDistance(double radius, double half) : radius_(radius), half_(half) {}
  Distance at(const Vec3& x) const override {
    const double r = std::hypot(x.x(), x.z());
    const Vec3 radial = r > 0 ? Vec3(x.x() / r, 0, x.z() / r) : Vec3(Vec3::UnitX());
    const Vec3 axial = x.y() < 0 ? Vec3(0, -1, 0) : Vec3(0, 1, 0);
    const double dr = r - radius_, dy = std::abs(x.y()) - half_;
    if (dr > 0 && dy > 0) {
      const double d = std::hypot(dr, dy);
      return {d, (dr * radial + dy * axial) / d};
    }
    return dr > dy ? Distance{dr, radial, 1 / radius_} : Distance{dy, axial};
  }

 private:
  double radius_, half_;
};

class EllipsoidDistance final : public SignedDistance {
 public:
  explicit EllipsoidDistance(const Vec3& half) : half_(half) {}
  Distance at(const Vec3& x) const override {
    const Vec3 unit = x.cwiseQuotient(half_), gradient = unit.cwiseQuotient(half_);
    const double level = unit.norm(), slope = gradient.norm();
    if (!(slope > 0)) return {-half_.minCoeff(), Vec3::UnitY()};
    // Mean curvature sum, of a sphere with the mean half extent.
    return {level * (level - 1) / slope, gradient / slope, 2 * 3 / half_.sum()};
  }

 private:
  Vec3 half_;
};

}  // namespace

std::unique_ptr<SignedDistance> make_signed_distance(const collision::ShapePart& part) {
  switch (part.kind) {
    case collision::ShapeKind::box:
      return std::make_unique<BoxDistance>(part.half);
    case collision::ShapeKind::sphere:
      return std::make_unique<CapsuleDistance>(part.half.x(), 0);
    case collision::ShapeKind::capsule:
      return std::make_unique<CapsuleDistance>(part.half.x(), part.half.y());
    case collision::ShapeKind::cylinder:
      return std::make_unique<CylinderDistance>(part.half.x(), part.half.y());
    case collision::ShapeKind::ellipsoid:
      return std::make_unique<EllipsoidDistance>(part.half);
    case collision::ShapeKind::hull:
    case collision::ShapeKind::triangles:
      break;
  }
  return std::make_unique<GridDistance>(*part.mesh);
}

}  // namespace prosector::contact
