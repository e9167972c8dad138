#pragma once
// A screen that acts as a window into the room: the camera follows the user's eyes.

#include <memory>

#include "client/app/desk/eye_window.h"
#include "client/app/run/screen_mode.h"

namespace prosector {

class EyeWindowMode : public GuidedMode {
 public:
  /// Opens the device that tracks the user's eyes. The view is shown by `screen`. Throws InputError if the
  /// device's settings are unusable.
  EyeWindowMode(ViewerContext& client, std::unique_ptr<ScreenMode> screen, const WindowSettings& settings);

  /// Updates the position of the user's eyes from the eye tracker, also when no frame is rendered. Returns
  /// whether to render a frame.
  bool begin_frame() override;
  Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) override;

 private:
  EyeWindow eyes_;
  bool has_look_ = false;  // an eye position was read
};

}  // namespace prosector
