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

/// Request for a frame of both eyes side by side, each of this size.
struct HeadsetFrame {
  std::array<EyeView, 2> eyes;  // left, right, room frame, at the display time
  int width = 0, height = 0;    // pixels, each eye
  TrackedUser user;             // at the display time

  /// Returns the cameras of both eyes in one image.
  std::array<DrawCamera, 2> cameras() const {
    return {camera_of(eyes[0], 0, width, height), camera_of(eyes[1], width, width, height)};
  }
};

/// Message about the headset, for the terminal and, if for_wearer, also for the headset's display.
struct HeadsetNews {
  std::string line;
  bool for_wearer = false;
};

/// Reports whether the runtime supports EGL, not only GLX; true if no runtime answers. Throws InputError if
/// the OpenXR loader is missing.
bool headset_takes_egl();

class Headset {
 public:
  /// Connects to the headset. `context` renders and must outlive this; `room_stage`: pose of the headset's
  /// stage in the room frame. Throws InputError if loader or runtime are missing or unsuitable; a headset
  /// that isn't connected is awaited. An own thread calls `take_user` with the user's current poses in the
  /// room frame, independently of the frame rate.
  Headset(const GlContext& context, const Pose& room_stage,
          std::function<void(const TrackedUser& user)> take_user);
  ~Headset();

  /// Waits for the next frame and begins it. Returns it if it must be rendered: then show() must follow.
  std::optional<HeadsetFrame> next_frame();
  /// Submits the image of both eyes side by side that `draw` copies into the texture.
  void show(const std::function<void(unsigned texture)>& draw);
  /// Reports whether next_frame() waited for the headset's frame timing; false while it has none.
  bool keeps_time() const { return keeps_time_; }
  /// Returns the timing of all frames.
  const FramePacing& pacing() const { return pacing_; }
  /// Reports whether the program was ended in the headset's own menu.
  bool closed() const { return closed_; }
  /// Returns the messages since the last call.
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
