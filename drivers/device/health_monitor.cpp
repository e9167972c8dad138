#include "drivers/device/health_monitor.h"

namespace prosector {
namespace {

constexpr std::int64_t window_length_ns = 500'000'000;
constexpr std::uint64_t babble_bytes = 64;  // garbage bytes in two windows up to which the device does not
                                            // count as babbling

}  // namespace

void HealthMonitor::opened(std::int64_t now_ns) {
  open_ = true;
  streamed_ = false;
  ++opens_;
  opened_ns_ = last_ns_ = window_ns_ = now_ns;
  now_ = before_ = {};
}

void HealthMonitor::lost() {
  open_ = false;
}

void HealthMonitor::roll_window(std::int64_t now_ns) {
  if (now_ns - window_ns_ < window_length_ns) return;
  before_ = now_ns - window_ns_ < 2 * window_length_ns ? now_ : Window{};
  now_ = {};
  window_ns_ = now_ns;
}

void HealthMonitor::record(std::int64_t now_ns, std::size_t bytes) {
  roll_window(now_ns);
  ++records_;
  streamed_ = true;
  last_ns_ = now_ns;
  now_.valid += bytes;
}

void HealthMonitor::garbage(std::int64_t now_ns, std::size_t bytes) {
  if (bytes == 0) return;
  roll_window(now_ns);
  ++resyncs_;
  skipped_bytes_ += bytes;
  last_garbage_ns_ = now_ns;
  now_.garbage += bytes;
}

DeviceHealth HealthMonitor::health(std::int64_t now_ns) const {
  if (!open_) return DeviceHealth::absent;
  const std::uint64_t garbage = now_.garbage + before_.garbage, valid = now_.valid + before_.valid;
  const bool recent = now_ns - last_garbage_ns_ < silence_limit_ns;
  if (recent && garbage > babble_bytes && garbage > valid) return DeviceHealth::babbling;
  if (quiet_ns(now_ns) > silence_limit_ns) return DeviceHealth::silent;
  return streamed_ ? DeviceHealth::streaming : DeviceHealth::connecting;
}

DeviceStatus HealthMonitor::status(std::int64_t now_ns) const {
  DeviceStatus out;
  out.health = health(now_ns);
  out.records = records();
  out.resyncs = resyncs();
  out.skipped_bytes = skipped_bytes();
  out.reopens = reopens();
  return out;
}

}  // namespace prosector
