#pragma once
// A session with a headset: its states, its frames and the pictures that it is given. Private to client/xr.

#include <functional>

#include "client/render/gl_context.h"
#include "client/xr/eye_view.h"
#include "client/xr/xr_input.h"

namespace prosector {

class XrRun {
 public:
  /// Begins a session that draws with the context; `tell` hears what becomes of it.
  XrRun(const XrSystem& system, const GlContext& context, std::function<void(const std::string&)> tell);
  ~XrRun();
  XrRun(const XrRun&) = delete;
  XrRun& operator=(const XrRun&) = delete;

  /// Follows what the runtime says: begins, ends. Throws XrFailure when session or runtime are lost.
  void follow_events();
  /// Tells whether frames are wanted: then each wait() needs its end().
  bool running() const { return running_; }
  /// Tells whether the runtime asks to leave.
  bool over() const { return over_; }

  /// Waits for the next frame, and begins it. Returns whether a picture of it will be seen.
  bool wait();
  /// Returns when the frame is seen, and how far apart frames are; ns of the runtime's clock.
  std::int64_t seen_ns() const { return frame_.predictedDisplayTime; }
  std::int64_t period_ns() const { return frame_.predictedDisplayPeriod; }
  /// Reads what the user presses.
  void sync();
  /// Returns both eyes when the frame is seen, in the stage; nullopt: the headset doesn't know.
  std::optional<std::array<EyeView, 2>> eyes();
  /// Returns the user when the frame is seen, in the stage.
  TrackedUser user_then() const { return input_.locate(stage_, frame_.predictedDisplayTime); }
  /// Tells whether user_now() is known.
  bool has_user() const { return running_ && synced_ns_ != 0; }
  /// Returns the user now, in the stage; where the runtime tells no time, when the last frame is seen.
  TrackedUser user_now() const;
  /// Ends the frame with the picture of both eyes that `draw` copies into the texture.
  void end(const std::function<void(unsigned texture)>& draw);
  /// Ends the frame without a picture.
  void end_empty();

  int eye_width() const { return width_; }
  int eye_height() const { return height_; }

 private:
  const XrSystem& system_;
  const XrFunctions& xr_;
  const GlContext& context_;
  std::function<void(const std::string&)> tell_;
  XrSession session_ = XR_NULL_HANDLE;
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  bool running_ = false, over_ = false, focused_ = false, had_focus_ = false;
  int width_, height_;  // pixels, each eye
  XrSpace stage_ = XR_NULL_HANDLE;
  XrSwapchain pictures_ = XR_NULL_HANDLE;
  std::vector<XrSwapchainImageOpenGLKHR> images_;
  XrFrameState frame_{};
  XrTime synced_ns_ = 0;  // when the frame is seen that what is pressed was read for; 0: none was
  std::array<XrView, 2> views_{};
  XrInput input_;

  static XrSession begin_session(const XrSystem& system, const GlContext& context);
  void make_stage();
  void make_pictures();
  void enter(XrSessionState state);
  void follow_focus(bool focused);
  void end(const XrCompositionLayerBaseHeader* layer);
};

}  // namespace prosector
