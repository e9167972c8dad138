#include "client/app/run/headset_mode.h"

#include <fmt/format.h>

#include "client/app/run/audience_settings.h"
#include "client/view/headset_text.h"
#include "common/error.h"

namespace prosector {

HeadsetMode::HeadsetMode(ViewerContext& client, HeadsetUser& user) : ViewMode(client) {
  make_context();
  headset_ = std::make_unique<Headset>(*context_, client.options.devices.headset_room,
                                       [&user](const TrackedUser& now) { user.put(now); });
}

/// Creates a context that the headset's runtime supports, with a window if there is an audience or the
/// runtime needs one.
void HeadsetMode::make_context() {
  const ClientOptions& o = client_.options;
  const bool by_egl = headset_takes_egl();
  if (by_egl && !o.display.audience) {
    context_ = make_egl_context(o.display.width, o.display.height);
    return;
  }
  const auto audience = o.display.audience ? std::optional(audience_settings(o.display)) : std::nullopt;
  try {
    auto mirror = make_mirror_context(by_egl ? WindowSystem::egl : WindowSystem::glx, o.display.width,
                                      o.display.height, audience);
    mirror_ = mirror.get();
    context_ = std::move(mirror);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--display openxr: {}: {}",
                                 by_egl
                                     ? "--spectator-window needs a window"
                                     : "the OpenXR runtime accepts images by GLX only, which needs a window",
                                 error.what()));
  }
}

bool HeadsetMode::begin_frame() {
  auto frame = headset_->next_frame();
  for (const HeadsetNews& news : headset_->take_news())
    news.for_wearer ? client_.inform(client_.options.words.tr(news.line)) : client_.print_line(news.line);
  if (!frame) {
    if (mirror_ != nullptr) mirror_->wait();
    return false;
  }
  frame_ = std::move(frame);
  return true;
}

Outlook HeadsetMode::look(InputPump* /*pump*/, LocalUser& self, const Outlook& usual) {
  Outlook out = usual;
  out.width = context_->width();
  out.height = context_->height();
  if (!frame_) return out;
  out.projection = HeadsetEyes{frame_->cameras()};
  out.width = 2 * frame_->width;
  out.height = frame_->height;
  for (std::size_t hand : {left_hand, right_hand})
    if (const auto& then = frame_->user.hands[hand]; then && self.input.hands[hand].tracked) {
      self.input.hands[hand].pose = then->wrist;
      self.input.hands[hand].flexion = then->flexion;
    }
  return out;
}

void HeadsetMode::render(Renderer& renderer, const DrawList& list, const Outlook& outlook) {
  frame_ ? renderer.draw(list, outlook.width, outlook.height) : renderer.draw(list);
}

void HeadsetMode::show(Renderer& renderer, const FrameTimes& /*times*/) {
  submit(renderer);
}

/// Submits the rendered frame to the headset and the mirror window.
void HeadsetMode::submit(Renderer& renderer) {
  const auto copy = [&renderer](unsigned texture) { renderer.copy_to(texture); };
  headset_->show(copy);
  if (mirror_ != nullptr) mirror_->show(2 * frame_->width, frame_->height, copy);
}

void HeadsetMode::show_loading(Renderer& renderer, const LoadingState& state) {
  if (!begin_frame()) return;
  DrawList list;
  list.scale = scale();
  const auto eyes = frame_->cameras();
  list.cameras.assign(eyes.begin(), eyes.end());
  add_headset_text(list, fmt::format("{}: {:.0f} %\n{}", client_.options.bus.session, 100 * state.progress,
                                     state.waits_for));
  renderer.draw(list, 2 * frame_->width, frame_->height);
  submit(renderer);
}

double HeadsetMode::display_scale() const {
  return frame_ ? headset_pixels_per_point(frame_->cameras()[0]) : 1;
}

}  // namespace prosector
