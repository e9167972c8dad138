#pragma once
// Convex shapes given by their support functions, for GJK and EPA.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"

namespace prosector {

/// Convex shape in its own frame: a core, and all points within `rounding` of the core. The core lies within
/// `reach` of `center`.
class Convex {
 public:
  virtual ~Convex() = default;
  /// Returns the core's support point: the farthest in a direction, which must not be zero but need not be
  /// unit.
  virtual Vec3 farthest(const Vec3& direction) const = 0;

  const Vec3& center() const { return center_; }
  double reach() const { return reach_; }
  double rounding() const { return rounding_; }

 protected:
  Convex(const Vec3& center, double reach, double rounding)
      : center_(center), reach_(reach), rounding_(rounding) {}

 private:
  Vec3 center_;
  double reach_, rounding_;  // m
};

/// A box about the origin.
class ConvexBox final : public Convex {
 public:
  explicit ConvexBox(const Vec3& half) : Convex(Vec3::Zero(), half.norm(), 0), half_(half) {}
  Vec3 farthest(const Vec3& direction) const override {
    return (direction.array() < 0).select(-half_, half_);
  }

 private:
  Vec3 half_;
};

/// A sphere: a point with rounding.
class ConvexBall final : public Convex {
 public:
  ConvexBall(const Vec3& center, double radius) : Convex(center, 0, radius) {}
  Vec3 farthest(const Vec3&) const override { return center(); }
};

/// Convex shape that also has faces, for contact with triangle meshes.
class FacetedConvex : public Convex {
 public:
  /// Returns the faces. Round shapes are tessellated within `chord_error` or with 48 segments around
  /// (common/scene/primitives.h). Hulls of points are accurate to 1e-4 of their size.
  virtual std::shared_ptr<const TriangleSurface> faces() const = 0;
  /// Returns the part of the rounding that the faces do not include, m.
  virtual double faces_rounding() const { return 0; }

 protected:
  using Convex::Convex;
};

/// Convex hull of a soft surface's current points. Support points are found with the surface's tree, so a
/// moved surface needs no new hull. faces() builds a new hull at each call.
class SurfaceHull final : public FacetedConvex {
 public:
  SurfaceHull(std::shared_ptr<const TriangleSurface> surface, double rounding)
      : FacetedConvex(surface->box().center(), surface->box().half().norm(), rounding),
        surface_(std::move(surface)) {}
  Vec3 farthest(const Vec3& direction) const override {
    return surface_->positions()[surface_->farthest(direction)];
  }
  std::shared_ptr<const TriangleSurface> faces() const override;
  double faces_rounding() const override { return rounding(); }

 private:
  std::shared_ptr<const TriangleSurface> surface_;
};

/// Exact convex hull of a set of points.
class PointHull final : public FacetedConvex {
 public:
  /// Throws InputError without points.
  explicit PointHull(const std::vector<Vec3>& points);
  Vec3 farthest(const Vec3& direction) const override;
  std::shared_ptr<const TriangleSurface> faces() const override { return faces_; }
  /// Returns the points that may be corners of the hull.
  const std::vector<Vec3>& points() const { return points_; }

 private:
  PointHull(std::vector<Vec3> outer, const Aabb& box);
  std::vector<Vec3> points_;
  std::shared_ptr<const TriangleSurface> faces_;
};

/// Creates the convex shape of a part other than box and sphere, in the part's frame. Capsule, cylinder and
/// ellipsoid are exact; hull and triangles become the hull of their points.
std::shared_ptr<const FacetedConvex> make_convex(const ShapePart& part);

/// Creates a part's triangle surface, in the part's frame. Throws InputError for a size that is not positive
/// and finite.
std::shared_ptr<const TriangleSurface> part_surface(const ShapePart& part);

/// Creates a box of twelve triangles; the volume is zero if an extent is 0.
std::shared_ptr<const TriangleSurface> box_surface(const Vec3& half);

/// Throws InputError for a size that is not positive and finite, or for a missing mesh.
void check_part(const ShapePart& part);

}  // namespace prosector
