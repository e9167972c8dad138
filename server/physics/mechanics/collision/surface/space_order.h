#pragma once
// Spatial ordering of points: nearby points get nearby positions in the order.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/base/list_edit.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector::collision {

/// Order of points along a Morton curve, in which neighbouring points are near each other. The curve passes
/// through the points' bounding box, with 1024 cells along its longest side. Points in the same cell are
/// ordered by index.
class SpaceOrder {
 public:
  SpaceOrder() = default;
  /// Sorts the points along the curve, in linear time.
  explicit SpaceOrder(std::vector<Vec3> points);
  /// Updates the order after points were added to and removed from the list; the result equals a rebuild.
  /// `come`: positions of the added points. They are merged into the order; all points are sorted again if
  /// the bounding box changed.
  void follow(const ListEdit& edit, std::span<const Vec3> come);

  std::size_t size() const { return order_.size(); }
  std::uint32_t operator[](std::size_t i) const { return order_[i]; }
  std::span<const std::uint32_t> order() const { return order_; }

 private:
  void sort();
  std::uint32_t code(const Vec3& point) const;

  std::vector<Vec3> points_;
  Aabb box_;
  std::vector<std::uint32_t> order_, codes_;  // point indices in curve order, and their Morton codes
};

}  // namespace prosector::collision
