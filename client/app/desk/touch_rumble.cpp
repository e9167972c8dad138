#include "client/app/desk/touch_rumble.h"

namespace prosector {
namespace {

constexpr std::int64_t asks_again_ns = 3'000'000'000;

}  // namespace

void TouchRumble::follow(bool has_gamepad, double force, std::int64_t now_ns) {
  if (!has_gamepad) {
    rumble_.reset();
    asked_ns_.reset();
    return;
  }
  if (!rumble_ && (!asked_ns_ || now_ns - *asked_ns_ > asks_again_ns)) {
    asked_ns_ = last_ns_ = now_ns;
    if (auto motors = open_()) rumble_.emplace(std::move(motors));
  }
  if (!rumble_) return;
  const double dt = 1e-9 * static_cast<double>(now_ns - *last_ns_);
  last_ns_ = now_ns;
  if (!rumble_->follow(force, dt)) rumble_.reset();
}

}  // namespace prosector
