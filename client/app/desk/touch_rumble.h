#pragma once
// Gamepad rumble of a desk user, driven by the contact force on their hand.

#include <cstdint>
#include <functional>
#include <optional>

#include "drivers/gamepad/rumble.h"

namespace prosector {

class TouchRumble {
 public:
  using Open = std::function<std::unique_ptr<RumbleMotors>()>;
  explicit TouchRumble(Open open = open_rumble) : open_(std::move(open)) {}

  /// Updates the gamepad's rumble to the force on the user's hand, N. `now_ns`: monotonic time. Without a
  /// gamepad its motors are not opened. After a failed attempt to open them it retries every 3 s, because the
  /// gamepad may be another one by then.
  void follow(bool has_gamepad, double force, std::int64_t now_ns);

 private:
  Open open_;
  std::optional<Rumble> rumble_;
  std::optional<std::int64_t> asked_ns_, last_ns_;
};

}  // namespace prosector
