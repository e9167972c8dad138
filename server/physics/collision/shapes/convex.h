#pragma once
// Convex shapes as what GJK and EPA ask of them: the point that lies farthest in a direction.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/collision/shapes/shape.h"
#include "server/physics/collision/surface/triangle_surface.h"

namespace prosector {

/// A core and all points within `rounding` of it, in its own frame. The core lies within `reach` of `center`.
class Convex {
 public:
  virtual ~Convex() = default;
  /// Returns the core's farthest point that way; the direction need not be unit, but not zero.
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

/// One that has faces too, for meeting triangle meshes.
class FacetedConvex : public Convex {
 public:
  /// Returns the faces: round shapes within `chord_error` or 48 segments around (common/primitives.h), hulls
  /// of points within 1e-4 of their size.
  virtual std::shared_ptr<const TriangleSurface> faces() const = 0;
  /// Returns what of the rounding the faces lack, m.
  virtual double faces_rounding() const { return 0; }

 protected:
  using Convex::Convex;
};

/// What moves along with a soft surface: the hull of its points, found through its tree. So a moved surface
/// needs no new hull. faces() makes one anew each time it is called.
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

/// The hull of points, exactly of all of them.
class PointHull final : public FacetedConvex {
 public:
  /// Throws InputError without points.
  explicit PointHull(const std::vector<Vec3>& points);
  Vec3 farthest(const Vec3& direction) const override;
  std::shared_ptr<const TriangleSurface> faces() const override { return faces_; }
  /// Returns those that may be corners.
  const std::vector<Vec3>& points() const { return points_; }

 private:
  PointHull(std::vector<Vec3> outer, const Aabb& box);
  std::vector<Vec3> points_;
  std::shared_ptr<const TriangleSurface> faces_;
};

/// Makes a part that is neither box nor sphere, in its own frame: capsule, cylinder and ellipsoid exactly,
/// hull and triangles as the hull of their points.
std::shared_ptr<const FacetedConvex> make_convex(const ShapePart& part);

/// Makes a part's surface as triangles, in its own frame. Throws InputError for a size that isn't positive
/// and finite.
std::shared_ptr<const TriangleSurface> part_surface(const ShapePart& part);

/// Makes twelve triangles, of no volume where an extent is 0.
std::shared_ptr<const TriangleSurface> box_surface(const Vec3& half);

/// Throws InputError for a size that isn't positive and finite, or a mesh that isn't there.
void check_part(const ShapePart& part);

}  // namespace prosector
