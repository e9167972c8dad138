#include "twins/trackers/space_mouse_twin.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double counts_per_speed = space_mouse::full_push / 0.25;  // counts per m/s of the hand, outside the
                                                                    // dead zone
constexpr double dead_zone_counts = 0.03 * space_mouse::full_push;

}  // namespace

void SpaceMouseTwin::produce(std::int64_t now_ns, std::vector<TwinOutput>& out) {
  if (!clock_.due(now_ns)) return;
  const Vec3 here = clock_.pose(0, now_ns).p;
  space_mouse::Record motion;
  if (before_) {
    const Vec3 speed = (here - *before_) / (1e-9 * static_cast<double>(now_ns - before_ns_));
    const Vec3 wanted(speed.x(), speed.y(), -speed.z());
    for (int i = 0; i < 3; ++i) {
      const double share = 1 - dead_zone_counts / space_mouse::full_push;
      const double counts = counts_per_speed * share * wanted[i];
      motion.push[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(
          std::lround(std::abs(counts) < 0.5
                          ? 0
                          : std::clamp(counts + std::copysign(dead_zone_counts, counts), -500.0, 500.0)));
    }
    motion.period_ms = static_cast<std::int32_t>((now_ns - before_ns_) / 1'000'000);
  }
  before_ = here;
  before_ns_ = now_ns;
  TwinOutput& record = out.emplace_back();
  const auto bytes = space_mouse::encode(motion);
  record.bytes.assign(bytes.begin(), bytes.end());
  record.is_record = true;
  record.record = records_++;
  for (const std::int32_t push : motion.push) record.values.push_back(static_cast<float>(push));
}

}  // namespace prosector
