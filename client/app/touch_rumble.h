#pragma once
// What the hand of a desk user touches, as their gamepad's rumble.

#include <cstdint>
#include <functional>
#include <optional>

#include "drivers/rumble.h"

namespace prosector {

class TouchRumble {
 public:
  using Open = std::function<std::unique_ptr<RumbleMotors>()>;
  explicit TouchRumble(Open open = open_rumble) : open_(std::move(open)) {}

  /// Takes the force on the hand, N, at a moment, ns. Without a gamepad nothing is opened; one that has no
  /// motors is asked again now and then, for it may be another by then.
  void follow(bool has_gamepad, double force, std::int64_t now_ns);

 private:
  Open open_;
  std::optional<Rumble> rumble_;
  std::optional<std::int64_t> asked_ns_, last_ns_;
};

}  // namespace prosector
