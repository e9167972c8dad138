#pragma once
// OpenXR session: state, frames and swapchain. Private to client/xr.

#include <functional>

#include "client/render/gl_context.h"
#include "client/xr/eye_view.h"
#include "client/xr/xr_input.h"

namespace prosector {

class HeadsetSession {
 public:
  /// Creates an OpenXR session that renders with the context. `report` receives messages for the user on the
  /// session's state.
  HeadsetSession(const XrSystem& system, const GlContext& context,
                 std::function<void(const std::string&)> report);
  ~HeadsetSession();
  HeadsetSession(const HeadsetSession&) = delete;
  HeadsetSession& operator=(const HeadsetSession&) = delete;

  /// Processes the OpenXR runtime's events, which begin and end the session's frames. Throws XrFailure if
  /// session or runtime are lost.
  void follow_events();
  /// Returns whether the OpenXR runtime requests frames. While it does, end() or end_without_image() must
  /// follow each wait().
  bool running() const { return running_; }
  /// Returns whether the OpenXR runtime asks the program to exit.
  bool over() const { return over_; }

  /// Waits until the OpenXR runtime requests the next frame, and begins that frame. Returns whether to render
  /// it; false if it would be invisible.
  bool wait();
  /// Returns the current frame's predicted display time; period_ns() returns the display period. Both are in
  /// ns of the OpenXR runtime's clock.
  std::int64_t seen_ns() const { return frame_.predictedDisplayTime; }
  std::int64_t period_ns() const { return frame_.predictedDisplayPeriod; }
  /// Updates the state of the controllers' buttons and triggers for the current frame.
  void sync();
  /// Returns pose and field of view of both eyes, left first, at the frame's display time, in the frame of
  /// the headset's stage. Returns nullopt if the headset is not tracked.
  std::optional<std::array<EyeView, 2>> eyes();
  /// Returns the poses of the user's head and hands at the frame's predicted display time, in the frame of
  /// the headset's stage.
  TrackedUser user_at_display() const { return input_.locate(stage_, frame_.predictedDisplayTime); }
  /// Returns whether user_now() can be called: the session runs, and the inputs were read at least once.
  bool has_user() const { return running_ && synced_ns_ != 0; }
  /// Returns the poses of the user's head and hands at the present time, in the frame of the headset's stage.
  /// If the runtime can't convert times, returns those at the last frame's display time.
  TrackedUser user_now() const;
  /// Ends the frame and submits the image of both eyes side by side. `draw` must copy the image into the
  /// OpenGL texture that it is called with.
  void end(const std::function<void(unsigned texture)>& draw);
  /// Ends the begun frame without submitting an image; the headset then shows nothing of this program.
  void end_without_image();

  int eye_width() const { return width_; }
  int eye_height() const { return height_; }

 private:
  const XrSystem& system_;
  const XrFunctions& xr_;
  const GlContext& context_;
  std::function<void(const std::string&)> report_;
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
