#include "server/physics/mechanics/collision/surface/space_order.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "common/assert.h"

namespace prosector::collision {
namespace {

/// Inserts two zero bits between adjacent bits of a 10-bit number.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FFU;
  bits = (bits | bits << 8) & 0x0300F00FU;
  bits = (bits | bits << 4) & 0x030C30C3U;
  return (bits | bits << 2) & 0x09249249U;
}

constexpr double last_cell = 1023;  // index of the last cell along the longest side

Aabb box_around(std::span<const Vec3> points) {
  Aabb box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

bool at_a_side(const Aabb& box, const Vec3& point) {
  return (point.array() == box.lo.array()).any() || (point.array() == box.hi.array()).any();
}

}  // namespace

SpaceOrder::SpaceOrder(std::vector<Vec3> points) : points_(std::move(points)), box_(box_around(points_)) {
  sort();
}

/// Returns the Morton code of a point: 10 bits of each coordinate, interleaved.
std::uint32_t SpaceOrder::code(const Vec3& point) const {
  const Vec3 unit = (point - box_.lo) / std::max((box_.hi - box_.lo).maxCoeff(), 1e-9);
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
    code |= spread(static_cast<std::uint32_t>(std::clamp(unit[axis], 0.0, 1.0) * last_cell)) << axis;
  return code;
}

/// Sorts the points by Morton code with a radix sort, lowest digit first; each pass is stable.
void SpaceOrder::sort() {
  constexpr unsigned digit_bits = 10, digits = 3, values = 1U << digit_bits;
  struct Entry {
    std::uint32_t code, index;
  };
  std::vector<Entry> entries, sorted(points_.size());
  entries.reserve(points_.size());
  for (std::uint32_t i = 0; i < points_.size(); ++i) entries.push_back({code(points_[i]), i});
  for (unsigned digit = 0; digit < digits; ++digit) {
    const auto value = [&](const Entry& entry) { return entry.code >> (digit * digit_bits) & (values - 1); };
    std::array<std::uint32_t, values + 1> begin{};
    for (const Entry& entry : entries) ++begin[value(entry) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (const Entry& entry : entries) sorted[begin[value(entry)]++] = entry;
    entries.swap(sorted);
  }
  order_.clear();
  codes_.clear();
  order_.reserve(entries.size());
  codes_.reserve(entries.size());
  for (const Entry& entry : entries) {
    order_.push_back(entry.index);
    codes_.push_back(entry.code);
  }
}

void SpaceOrder::follow(const ListEdit& edit, std::span<const Vec3> come) {
  PROSECTOR_ASSERT(order_.size() == points_.size() && codes_.size() == order_.size());
  const bool may_shrink = std::any_of(edit.gone.begin(), edit.gone.end(),
                                      [&](std::uint32_t i) { return at_a_side(box_, points_[i]); });
  apply(edit, come, points_);
  Aabb box = may_shrink ? box_around(points_) : box_;
  for (const Vec3& point : come) box.add(point);
  if (box.lo != box_.lo || box.hi != box_.hi) {
    box_ = box;
    sort();
    return;
  }
  struct Entry {
    std::uint32_t code, index;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> coming;
  for (std::size_t i = 0; i < come.size(); ++i) coming.push_back({code(come[i]), edit.come[i]});
  std::sort(coming.begin(), coming.end());
  std::vector<std::uint32_t> order, codes;
  order.reserve(points_.size());
  codes.reserve(points_.size());
  const auto add = [&](const Entry& entry) {
    order.push_back(entry.index);
    codes.push_back(entry.code);
  };
  auto next = coming.begin();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Entry staying{codes_[i], edit.now[order_[i]]};
    if (staying.index == ListEdit::none) continue;
    for (; next != coming.end() && *next < staying; ++next) add(*next);
    add(staying);
  }
  for (; next != coming.end(); ++next) add(*next);
  PROSECTOR_ASSERT(order.size() == points_.size());
  order_ = std::move(order);
  codes_ = std::move(codes);
}

}  // namespace prosector::collision
