#pragma once
// Frames without a display, for screenshots and videos: seen from the scene's camera, the tracked head, or a
// camera requested at the terminal.

#include <memory>

#include "client/app/run/screen_mode.h"

namespace prosector {

class OffscreenMode : public ScreenMode {
 public:
  OffscreenMode(ViewerContext& client, std::unique_ptr<GlContext> context);

  GlContext& context() override { return *context_; }
  bool is_watched() const override { return false; }
  Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) override;
  bool is_led_by_head(const LocalUser& self) const override;
  void set_window_look(const WindowLook& look) override { look_ = look; }
  DrawCamera window_camera() const override;

 private:
  std::unique_ptr<GlContext> context_;
  WindowLook look_;
};

}  // namespace prosector
