#include "server/physics/collision/space_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace prosector {
namespace {

/// The lower 10 bits, with two zeros between each two.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FFU;
  bits = (bits | bits << 8) & 0x0300F00FU;
  bits = (bits | bits << 4) & 0x030C30C3U;
  return (bits | bits << 2) & 0x09249249U;
}

/// Morton code: 10 bits of each coordinate, interleaved.
std::uint32_t morton(const Vec3& unit) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
    code |= spread(static_cast<std::uint32_t>(std::clamp(unit[axis], 0.0, 1.0) * 1023)) << axis;
  return code;
}

}  // namespace

std::vector<std::uint32_t> space_order(std::span<const Vec3> points) {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::max()), hi = -lo;
  for (const Vec3& p : points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  const double extent = points.empty() ? 1 : std::max((hi - lo).maxCoeff(), 1e-9);
  // By the code's digits, the lowest first: each pass keeps the order of the one before.
  constexpr unsigned digit_bits = 10, digits = 3, values = 1U << digit_bits;
  struct Entry {
    std::uint32_t code, index;
  };
  std::vector<Entry> entries, sorted(points.size());
  entries.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) entries.push_back({morton((points[i] - lo) / extent), i});
  for (unsigned digit = 0; digit < digits; ++digit) {
    const auto value = [&](const Entry& entry) { return entry.code >> (digit * digit_bits) & (values - 1); };
    std::array<std::uint32_t, values + 1> begin{};
    for (const Entry& entry : entries) ++begin[value(entry) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (const Entry& entry : entries) sorted[begin[value(entry)]++] = entry;
    entries.swap(sorted);
  }
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const Entry& entry : entries) order.push_back(entry.index);
  return order;
}

}  // namespace prosector
