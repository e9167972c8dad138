#include "client/app/run/eye_window_mode.h"

namespace prosector {

EyeWindowMode::EyeWindowMode(ViewerContext& client, std::unique_ptr<ScreenMode> screen,
                             const WindowSettings& settings)
    : GuidedMode(client, std::move(screen)), eyes_(settings) {}

bool EyeWindowMode::begin_frame() {
  if (const std::string news = eyes_.take_news(); !news.empty())
    client_.inform(client_.options.words.tr(news));
  const double fov = client_.connection.with_replica([](const Replica& r) { return r.scene()->camera.fov; });
  screen_->set_window_look(eyes_.look(monotonic_ns(), fov));
  has_look_ = true;
  return screen_->begin_frame();
}

Outlook EyeWindowMode::look(InputPump* pump, LocalUser& self, const Outlook& usual) {
  const bool led_by_head = screen_->is_led_by_head(self);
  Outlook out = screen_->look(pump, self, usual);
  if (has_look_ && !led_by_head) out.projection = WindowCamera{screen_->window_camera()};
  return out;
}

}  // namespace prosector
