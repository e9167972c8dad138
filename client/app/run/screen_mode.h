#pragma once
// A view mode whose camera another device may guide: a camera, or eyes in front of the screen.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/app/run/view_mode.h"
#include "client/view/window_view.h"

namespace prosector {

class ScreenMode : public ViewMode {
 public:
  using ViewMode::ViewMode;

  /// Returns whether the pose of the user's tracked head, rather than the screen's own controls, determines
  /// the camera.
  virtual bool is_led_by_head(const LocalUser& self) const = 0;
  /// Sets the position of the user's eyes in front of the screen, which acts as a window into the room.
  virtual void set_window_look(const WindowLook& look) = 0;
  /// Returns the camera for the eye position that set_window_look() set last. look() must be called before.
  virtual DrawCamera window_camera() const = 0;
  /// Makes the rays of the mouse pointer start at this camera; nullopt: at the screen's own camera. Does
  /// nothing for a screen without a pointer.
  virtual void follow_camera(const std::optional<DrawCamera>& /*camera*/) {}
};

/// View of a screen whose camera is determined by a device, such as a camera or an eye tracker. It is a
/// decorator of the screen's own view mode; derived classes override the functions that the device changes.
class GuidedMode : public ViewMode {
 public:
  GuidedMode(ViewerContext& client, std::unique_ptr<ScreenMode> screen)
      : ViewMode(client), screen_(std::move(screen)) {}

  GlContext& context() override { return screen_->context(); }
  bool closed() const override { return screen_->closed(); }
  bool is_watched() const override { return screen_->is_watched(); }
  void show_loading(Renderer& renderer, const LoadingState& state) override {
    screen_->show_loading(renderer, state);
  }
  std::vector<ControlDevice> controls() const override { return screen_->controls(); }
  std::optional<BodyId> pointed() const override { return screen_->pointed(); }
  std::optional<Pose> eye() const override { return screen_->eye(); }
  int take_picture_request() override { return screen_->take_picture_request(); }

 protected:
  std::unique_ptr<ScreenMode> screen_;

  double display_scale() const override { return screen_->scale(); }
};

}  // namespace prosector
