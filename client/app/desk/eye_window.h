#pragma once
// Eye tracking for a screen that acts as a window into the room: reads a device and computes the view.

#include <memory>
#include <string>
#include <vector>

#include "client/view/eased_eye_position.h"
#include "client/view/window_view.h"
#include "drivers/config/client_config.h"

namespace prosector {

class EyeWindow {
 public:
  /// Opens the device that tracks the user's eyes. Throws InputError if its settings are unusable.
  explicit EyeWindow(const WindowSettings& settings);

  /// Reads the eye-tracking device. Returns the position of the user's eyes in front of the screen and the
  /// view's size. `now_ns`: monotonic time. `fov`: vertical field of view, rad, of the plain camera whose
  /// view is shown while no eyes are tracked.
  WindowLook look(std::int64_t now_ns, double fov);
  /// Returns the status line of the eye-tracking device for the user, if it changed since the last call; else
  /// an empty string.
  std::string take_news();

 private:
  const WindowSettings settings_;
  std::unique_ptr<Device> device_;
  std::vector<DeviceSample> samples_;
  EasedEyePosition eye_;
  std::string last_status_;  // last reported status line
};

}  // namespace prosector
