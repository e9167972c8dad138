#pragma once
// Surface swept by a blade's edge between two ticks: a strip of triangles, two for each segment of the edge.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector::cutting {

class SweptSurface {
 public:
  struct Piece {
    std::array<Vec3, 3> corner;
    Vec3 normal;     // unit
    Vec3 up;         // unit: normal of the surface smoothed over the part
    Vec3 low, high;  // bounding box
  };
  struct Crossing {
    double t = 0;  // position along the segment, in [0, 1]
    Vec3 normal = Vec3::Zero();
  };
  struct Foot {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double distance = 0;
  };

  enum class Twist { flattened, followed };
  /// Builds the surface swept by a polyline that moves from `from` to `to` (equally many points, at least
  /// two, m). Triangles without area are left out. `part`: for each point, ascending, the part of the
  /// polyline that begins there. Within a part the surface is smooth: a triangle whose normal deviates
  /// strongly from the part's mean normal gets that as `up`.
  ///
  /// `twist` applies if the ends of a segment move differently. `flattened` sweeps two triangles, each with
  /// the motion of one end. `followed` divides the segment into strips whose ends hardly move differently.
  SweptSurface(std::span<const Vec3> from, std::span<const Vec3> to, std::span<const std::size_t> part,
               Twist twist = Twist::flattened);

  std::span<const Piece> pieces() const { return pieces_; }
  /// Returns where the segment a–b first crosses the swept surface, with the surface's normal there. Returns
  /// nothing if it does not cross, or is parallel to the surface.
  std::optional<Crossing> crossing(const Vec3& a, const Vec3& b) const;
  /// Returns the foot of x on the swept surface: distance and normal at the nearest triangle, and the
  /// projection of x. The projection is onto the plane through the triangle's point nearest to x, with the
  /// smoothed surface's normal Piece::up. Returns nothing if the distance exceeds `reach`, m.
  std::optional<Foot> foot(const Vec3& x, double reach) const;

 private:
  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& part_area);
  std::vector<Piece> pieces_;
};

}  // namespace prosector::cutting
