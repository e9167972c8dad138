#pragma once
// OpenXR headset: display and tracking. A lost connection is restored automatically.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "client/render/gl_context.h"
#include "client/xr/eye_view.h"
#include "client/xr/frame_pacing.h"
#include "client/xr/tracked_user.h"

namespace prosector {

/// Headset frame to render: both eyes side by side, each of `width` × `height` pixels, with the user's poses
/// at the display time.
struct HeadsetFrame {
  std::array<EyeView, 2> eyes;  // left, right, room frame, at the display time
  int width = 0, height = 0;    // pixels, each eye
  TrackedUser user;             // at the display time

  /// Returns the render cameras of the left and the right eye, whose viewports are side by side in one frame.
  std::array<DrawCamera, 2> cameras() const {
    return {camera_of(eyes[0], 0, width, height), camera_of(eyes[1], width, width, height)};
  }
};

/// Message about the headset's state for the terminal, and, if for_wearer is true, also for the headset's
/// display.
struct HeadsetNews {
  std::string line;
  bool for_wearer = false;
};

/// Returns whether the OpenXR runtime supports rendering by EGL, not only by GLX; true if no runtime answers.
/// Throws InputError if the OpenXR loader is missing.
bool headset_takes_egl();

class Headset {
 public:
  /// Connects to the headset. `context` renders and must outlive this object; `room_stage` is the pose of the
  /// headset's stage (its floor origin) in the room frame. Throws InputError if loader or runtime are missing
  /// or unsuitable. If the headset isn't connected, next_frame() retries until it is. A separate thread calls
  /// `take_user` with the user's current poses in the room frame, independently of the frame rate.
  Headset(const GlContext& context, const Pose& room_stage,
          std::function<void(const TrackedUser& user)> take_user);
  ~Headset();

  /// Waits for the headset's next frame and begins it. If the frame must be rendered, returns it, and show()
  /// must follow. Returns nullopt if there is nothing to render: no connection, or an invisible frame.
  std::optional<HeadsetFrame> next_frame();
  /// Submits the frame of both eyes side by side to the headset. `draw` must copy it into the OpenGL texture
  /// that it is called with.
  void show(const std::function<void(unsigned texture)>& draw);
  /// Returns whether the last next_frame() waited for the headset's frame timing. If false, the caller must
  /// limit its frame rate differently.
  bool keeps_time() const { return keeps_time_; }
  /// Returns the statistics of the headset's frame timing since the start.
  const FramePacing& pacing() const { return pacing_; }
  /// Returns whether the user ended the program in the headset's own menu.
  bool closed() const { return closed_; }
  /// Returns and removes the messages about the headset that were added since the last call.
  std::vector<HeadsetNews> take_news() { return std::exchange(news_, {}); }

 private:
  struct Parts;  // OpenXR objects

  const GlContext& context_;
  Pose room_stage_;
  std::function<void(const TrackedUser& user)> take_user_;
  std::mutex mutex_;              // guards parts_ and calls into its hand tracking
  std::unique_ptr<Parts> parts_;  // null: lost, or not connected yet
  std::int64_t tried_ns_ = 0;
  std::string reason_;  // last reported reason of the lost connection
  bool keeps_time_ = false, closed_ = false;
  FramePacing pacing_;
  std::vector<HeadsetNews> news_;
  std::jthread follower_;

  void follow_user();
  void connect();
  void lose(const std::string& why);
  std::optional<HeadsetFrame> frame();
  TrackedUser in_room(TrackedUser user) const;
};

}  // namespace prosector
