#include "drivers/device/stream_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/clock.h"
#include "drivers/device/plausible.h"

namespace prosector {
namespace {

constexpr std::int64_t first_reopen_ns = 100'000'000, last_reopen_ns = 2'000'000'000;
constexpr std::int64_t still_opening_ns = 10'000'000;
constexpr std::size_t poll_bytes = 65536;  // limit per poll(), so that a babbling device cannot block it

}  // namespace

StreamDevice::StreamDevice(std::unique_ptr<DevicePort> port)
    : port_(std::move(port)), open_delay_ns_(first_reopen_ns) {}

void StreamDevice::open(std::int64_t now_ns) {
  if (port_->open()) {
    if (refused_.empty()) open_delay_ns_ = first_reopen_ns;
    buffer_.clear();
    health_.opened(now_ns);
    started(now_ns);
  } else if (port_->is_opening()) {
    next_open_ns_ = now_ns + still_opening_ns;
  } else {
    if (!port_->error().empty()) refused_.clear();  // the unsuitable peer is gone
    increase_retry_delay(now_ns);
  }
}

void StreamDevice::increase_retry_delay(std::int64_t now_ns) {
  next_open_ns_ = now_ns + open_delay_ns_;
  open_delay_ns_ = std::min(2 * open_delay_ns_, last_reopen_ns);
}

void StreamDevice::refuse(std::string why) {
  refused_ = std::move(why);
  records_at_refusal_ = health_.records();
  port_->close();
}

void StreamDevice::poll(std::vector<DeviceSample>& out) {
  const std::int64_t now_ns = monotonic_ns();
  if (!port_->is_open() && now_ns >= next_open_ns_) open(now_ns);
  if (!port_->is_open()) return;
  chunk_.clear();
  port_->read(chunk_, poll_bytes);
  buffer_.append(chunk_, monotonic_ns());
  const std::size_t before = out.size();
  parse(now_ns, out);
  health_.garbage(now_ns, remove_implausible(out, before));
  if (health_.records() > records_at_refusal_) refused_.clear();
  if (port_->is_open()) advance(now_ns);
  if (!port_->is_open()) {
    health_.lost();
    next_open_ns_ = now_ns + first_reopen_ns;
    if (!refused_.empty()) increase_retry_delay(now_ns);
  }
}

DeviceStatus StreamDevice::status() const {
  DeviceStatus status = health_.status(monotonic_ns());
  const bool tried = !port_->error().empty() || status.reopens > 0 || status.records > 0;
  if (status.health == DeviceHealth::absent && !tried) status.health = DeviceHealth::connecting;
  if (!refused_.empty()) {
    status.health = DeviceHealth::babbling;
    status.message = fmt::format("{}: {}; retrying", port_->path(), refused_);
    return status;
  }
  switch (status.health) {
    case DeviceHealth::absent:
      status.message =
          fmt::format("{}; {}; retrying",
                      port_->error().empty() ? fmt::format("{} is not open", port_->path()) : port_->error(),
                      absent_hint());
      break;
    case DeviceHealth::silent:
      status.message = fmt::format("{} sends no data; {}; retrying", port_->path(), silent_hint());
      break;
    case DeviceHealth::babbling:
      status.message = fmt::format("{} sends no valid records; {}", port_->path(), babble_hint());
      break;
    case DeviceHealth::connecting:
      status.message = fmt::format("{} is starting", port_->path());
      break;
    case DeviceHealth::streaming:
      break;
  }
  return status;
}

}  // namespace prosector
