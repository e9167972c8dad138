#pragma once
// Convex shapes given by their support functions, for GJK and EPA.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"

namespace prosector::collision {

/// Convex shape in its own frame: a convex core, offset outwards by the radius `rounding`. The shape is all
/// points within `rounding` of the core. The core is contained in the ball of radius `reach` about `center`.
/// Lengths in metres.
class Convex {
 public:
  virtual ~Convex() = default;
  /// Returns the core's support point: the point of the core, without the rounding, that is farthest along
  /// `direction`. The direction and the point are in the shape's frame. The direction must not be zero but
  /// need not be a unit vector.
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

/// Convex shape of a box centred on the origin and aligned with the axes of the shape's frame, without
/// rounding.
class ConvexBox final : public Convex {
 public:
  explicit ConvexBox(const Vec3& half) : Convex(Vec3::Zero(), half.norm(), 0), half_(half) {}
  Vec3 farthest(const Vec3& direction) const override {
    return (direction.array() < 0).select(-half_, half_);
  }

 private:
  Vec3 half_;
};

/// Convex shape of a sphere: its core is a single point, and its rounding is the radius.
class ConvexBall final : public Convex {
 public:
  ConvexBall(const Vec3& center, double radius) : Convex(center, 0, radius) {}
  Vec3 farthest(const Vec3&) const override { return center(); }
};

/// Convex shape that can also return its surface as triangles, for contact with triangle meshes.
class FacetedConvex : public Convex {
 public:
  /// Returns the shape's surface as triangles, in the shape's frame. Capsules, cylinders and ellipsoids are
  /// tessellated to within `chord_error`, or with 48 segments around (common/scene/primitives.h). Hulls of
  /// points are accurate to 1e-4 of their size.
  virtual std::shared_ptr<const TriangleSurface> faces() const = 0;
  /// Returns the distance, m, by which the triangles of faces() must be offset outwards to give the shape's
  /// surface. It is 0 where the triangles include the rounding already.
  virtual double faces_rounding() const { return 0; }

 protected:
  using Convex::Convex;
};

/// Convex hull of the current vertices of a soft body's surface. Support points are searched in the surface's
/// own tree, so no hull is computed when the surface moves. Only faces() computes the hull, at each call.
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

/// Exact convex hull of a set of points, with its triangles.
class PointHull final : public FacetedConvex {
 public:
  /// Builds the hull of these points and its triangles. Throws InputError if there is no point.
  explicit PointHull(const std::vector<Vec3>& points);
  Vec3 farthest(const Vec3& direction) const override;
  std::shared_ptr<const TriangleSurface> faces() const override { return faces_; }
  /// Returns those of the given points that may be corners of the hull: all corners, and points within
  /// rounding of the hull's surface.
  const std::vector<Vec3>& points() const { return points_; }

 private:
  PointHull(std::vector<Vec3> outer, const Aabb& box);
  std::vector<Vec3> points_;
  std::shared_ptr<const TriangleSurface> faces_;
};

/// Creates the convex shape of a collision part that is neither a box nor a sphere, in the part's frame.
/// Capsules, cylinders and ellipsoids are exact. Parts of kind `hull` or `triangles` become the convex hull
/// of their mesh's points.
std::shared_ptr<const FacetedConvex> make_convex(const ShapePart& part);

/// Creates the triangle surface of a collision part, in the part's frame; round parts are tessellated. Throws
/// InputError for a size that is not positive and finite, or for a missing mesh.
std::shared_ptr<const TriangleSurface> part_surface(const ShapePart& part);

/// Creates the surface of a box as twelve triangles, centred on the origin. `half`: half extents, m; one may
/// be 0, which gives a flat box without volume.
std::shared_ptr<const TriangleSurface> box_surface(const Vec3& half);

/// Validates a collision part. Throws InputError for a size that is not positive and finite, for a missing or
/// empty mesh, or for a mesh vertex that is not finite.
void check_part(const ShapePart& part);

}  // namespace prosector::collision
