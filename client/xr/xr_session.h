#pragma once
// OpenXR session: state, frames and swapchain. Private to client/xr.

#include <functional>

#include "client/render/gl_context.h"
#include "client/xr/eye_view.h"
#include "client/xr/xr_input.h"

namespace prosector {

class HeadsetSession {
 public:
  /// Creates a session that renders with the context; `tell` receives messages on its state.
  HeadsetSession(const XrSystem& system, const GlContext& context,
                 std::function<void(const std::string&)> tell);
  ~HeadsetSession();
  HeadsetSession(const HeadsetSession&) = delete;
  HeadsetSession& operator=(const HeadsetSession&) = delete;

  /// Processes the runtime's events, which begin and end the session. Throws XrFailure if session or runtime
  /// are lost.
  void follow_events();
  /// Reports whether the runtime requests frames: then end() or end_without_image() must follow each wait().
  bool running() const { return running_; }
  /// Reports whether the runtime asks the program to exit.
  bool over() const { return over_; }

  /// Waits for the next frame and begins it. Returns whether to render it.
  bool wait();
  /// Returns the frame's predicted display time; period_ns() returns the display period. Both in ns of the
  /// runtime's clock.
  std::int64_t seen_ns() const { return frame_.predictedDisplayTime; }
  std::int64_t period_ns() const { return frame_.predictedDisplayPeriod; }
  /// Reads the controllers' inputs.
  void sync();
  /// Returns both eyes at the frame's display time, in the stage frame; nullopt: not tracked.
  std::optional<std::array<EyeView, 2>> eyes();
  /// Returns the user at the frame's display time, in the stage frame.
  TrackedUser user_at_display() const { return input_.locate(stage_, frame_.predictedDisplayTime); }
  /// Reports whether user_now() can be called.
  bool has_user() const { return running_ && synced_ns_ != 0; }
  /// Returns the user now, in the stage frame; if the runtime can't convert times, at the last frame's
  /// display time.
  TrackedUser user_now() const;
  /// Ends the frame with the image of both eyes that `draw` copies into the texture.
  void end(const std::function<void(unsigned texture)>& draw);
  /// Ends the frame without an image.
  void end_without_image();

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
  XrTime synced_ns_ = 0;  // display time of the frame for which the inputs were last read; 0: not read yet
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
