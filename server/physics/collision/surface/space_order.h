#pragma once
// Points in an order that keeps neighbours together.

#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/collision/primitives/aabb.h"
#include "server/physics/list_edit.h"

namespace prosector {

/// Along a Morton curve through the points' box, 1024 cells along its longest side; of the points in one cell
/// the first comes first.
class SpaceOrder {
 public:
  SpaceOrder() = default;
  /// Orders the points in linear time.
  explicit SpaceOrder(std::vector<Vec3> points);
  /// Follows a change to what the order of the points would be after it. Those that come are merged into it,
  /// unless the box is another.
  void follow(const ListEdit& edit, std::span<const Vec3> come);

  std::size_t size() const { return order_.size(); }
  std::uint32_t operator[](std::size_t i) const { return order_[i]; }
  std::span<const std::uint32_t> order() const { return order_; }

 private:
  void sort();
  std::uint32_t code(const Vec3& point) const;

  std::vector<Vec3> points_;
  Aabb box_;
  std::vector<std::uint32_t> order_, codes_;  // the points' indices, and their cells' places on the curve
};

}  // namespace prosector
