#pragma once
// The surface that a blade's edge sweeps between two ticks: a strip of triangles, two for each piece of edge.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

class SweptSurface {
 public:
  struct Piece {
    std::array<Vec3, 3> corner;
    Vec3 normal;     // unit
    Vec3 up;         // unit: of the sheet there
    Vec3 low, high;  // its box
  };
  struct Crossing {
    double t = 0;  // along the edge
    Vec3 normal = Vec3::Zero();
  };
  struct Foot {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double distance = 0;
  };

  enum class Twist { flattened, followed };
  /// Polylines of equally many points, at least two, metres; `part`: by point, ascending. Pieces without area
  /// are left out. What a part sweeps is smooth: where a piece's own normal is far from that of its part, the
  /// part's is the sheet's. Of a piece of edge whose ends go different ways two triangles have the motion of
  /// one end each; followed, it is divided until they hardly differ.
  SweptSurface(std::span<const Vec3> from, std::span<const Vec3> to, std::span<const std::size_t> part,
               Twist twist = Twist::flattened);

  std::span<const Piece> pieces() const { return pieces_; }
  /// Returns where the segment a–b goes through first; grazing along the sheet is none.
  std::optional<Crossing> crossing(const Vec3& a, const Vec3& b) const;
  /// Returns the sheet's point nearest to x, where it is nearer than `reach`.
  std::optional<Foot> foot(const Vec3& x, double reach) const;

 private:
  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& part_area);
  std::vector<Piece> pieces_;
};

}  // namespace prosector
