#include "client/app/run/offscreen_mode.h"

#include "client/view/camera.h"

namespace prosector {

OffscreenMode::OffscreenMode(ViewerContext& client, std::unique_ptr<GlContext> context)
    : ScreenMode(client), context_(std::move(context)) {}

Outlook OffscreenMode::look(InputPump* /*pump*/, LocalUser& /*self*/, const Outlook& usual) {
  Outlook out = usual;
  out.width = context_->width();
  out.height = context_->height();
  return out;
}

bool OffscreenMode::is_led_by_head(const LocalUser& self) const {
  return self.present && self.input.head_tracked;
}

DrawCamera OffscreenMode::window_camera() const {
  const CameraInfo camera =
      client_.connection.with_replica([](const Replica& r) { return r.scene()->camera; });
  const LookFrom from = client_.looks_from.value_or(LookFrom{camera.eye, camera.target});
  const DrawCamera rest =
      mono_camera(look_at(from.eye, from.target), camera.fov, context_->width(), context_->height());
  return look_through(rest, (from.target - from.eye).norm(), look_);
}

}  // namespace prosector
