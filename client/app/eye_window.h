#pragma once
// The user's eyes before the screen that is a window: what a device says of them, and what that makes of a
// view.

#include <memory>
#include <string>
#include <vector>

#include "client/view/followed_eye.h"
#include "client/view/window_view.h"
#include "drivers/client_config.h"

namespace prosector {

class EyeWindow {
 public:
  /// Opens the device that sees the eyes. Throws InputError where it can't be used at all.
  explicit EyeWindow(const WindowSettings& settings);

  /// Takes what the device saw. Returns how the user looks at a picture whose view, without a window, has
  /// that vertical field, rad.
  WindowLook look(std::int64_t now_ns, double fov);
  /// Returns what is to be told of the device since the last call; empty: nothing.
  std::string take_news();

 private:
  const WindowSettings settings_;
  std::unique_ptr<Device> device_;
  std::vector<DeviceSample> samples_;
  FollowedEye eye_;
  std::string told_;  // last
};

}  // namespace prosector
