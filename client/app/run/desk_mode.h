#pragma once
// A window for a desk user: mouse, keyboard and gamepad move the view and drive a hand.

#include <memory>
#include <string>
#include <vector>

#include "client/app/desk/desk.h"
#include "client/app/desk/touch_rumble.h"
#include "client/app/run/screen_mode.h"
#include "client/view/scene_view.h"

namespace prosector {

class DeskMode : public ScreenMode {
 public:
  /// Opens the window, and a second one for an audience if requested. `projection`: mono, or stereo side by
  /// side. Throws InputError if a window is unavailable.
  DeskMode(ViewerContext& client, SceneView& scene, const Projection& projection);

  GlContext& context() override { return *window_; }
  bool closed() const override { return desk_->closed(); }
  bool is_watched() const override { return true; }
  Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) override;
  void show_loading(Renderer& renderer, const LoadingState& state) override;
  std::vector<ControlDevice> controls() const override;
  std::optional<BodyId> pointed() const override { return desk_->pointed(); }
  std::optional<Pose> eye() const override { return desk_->view().eye(); }
  int take_picture_request() override { return desk_->display().take_picture_request(); }

  bool is_led_by_head(const LocalUser& self) const override;
  void set_window_look(const WindowLook& look) override { desk_->view().set_window_look(look); }
  DrawCamera window_camera() const override { return desk_->view().camera(); }
  void follow_camera(const std::optional<DrawCamera>& camera) override { leading_camera_ = camera; }

 protected:
  double display_scale() const override { return window_->content_scale(); }

 private:
  SceneView& scene_;
  Projection projection_;
  std::unique_ptr<WindowContext> window_;
  std::unique_ptr<Desk> desk_;
  TouchRumble rumble_;
  std::optional<DrawCamera> leading_camera_;  // camera that the view follows; nullopt: the desk controls it
  std::string follow_;                        // participant whose eyes give the view; empty: own view
  bool full_screen_ = false;

  DeskSession begin_desk_frame(ParticipantId self);
  double touch_force(ParticipantId self);
  Role role_of(ParticipantId participant);
  void follow_choices(const LocalUser& self, Outlook& out);
  void follow_next(ParticipantId self);
  void drive_hand(InputPump& pump, LocalUser& self, bool has_panel);
  void request_panel(const Ray& ray, bool has_panel);
  void send_time_commands();
};

}  // namespace prosector
