#pragma once
// An OpenXR headset, in its own frame rhythm, with an optional mirror window for an audience.

#include <memory>
#include <optional>

#include "client/app/run/view_mode.h"
#include "client/app/user/headset_user.h"
#include "client/render/mirror_context.h"
#include "client/xr/headset.h"

namespace prosector {

class HeadsetMode : public ViewMode {
 public:
  /// Connects to the headset, which passes its wearer's poses to `user`. `user` must outlive this object.
  /// Throws InputError if the OpenXR runtime or a window that it needs is unavailable.
  HeadsetMode(ViewerContext& client, HeadsetUser& user);

  GlContext& context() override { return *context_; }
  bool closed() const override { return headset_->closed(); }
  bool is_watched() const override { return true; }
  /// Waits for the headset's next frame, and shows the headset's messages. Returns whether a frame may be
  /// rendered.
  bool begin_frame() override;
  bool keeps_time() const override { return headset_->keeps_time(); }
  /// Returns the outlook (projection and display options) with the headset's eyes as cameras. Moves the
  /// user's own hands in `self` to their predicted poses at the display time.
  Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) override;
  void render(Renderer& renderer, const DrawList& list, const Outlook& outlook) override;
  void show(Renderer& renderer, const FrameTimes& times) override;
  void show_loading(Renderer& renderer, const LoadingState& state) override;
  void report(ClientReport& report) const override { report.pacing = headset_->pacing(); }

 protected:
  double display_scale() const override;

 private:
  std::unique_ptr<GlContext> context_;
  MirrorContext* mirror_ = nullptr;  // the context, if it is a mirror window; else null
  std::unique_ptr<Headset> headset_;
  std::optional<HeadsetFrame> frame_;  // last requested frame; nullopt: none yet

  void make_context();
  void submit(Renderer& renderer);
};

}  // namespace prosector
