#pragma once
// A headset by OpenXR: what its user sees and where they are. Lost, it comes back by itself.

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

/// A picture that is wanted: of both eyes side by side, each of that size.
struct HeadsetFrame {
  std::array<EyeView, 2> eyes;  // left, right, in the room, when the picture is seen
  int width = 0, height = 0;    // pixels, each eye
  TrackedUser user;             // when the picture is seen

  /// Returns both eyes as cameras of one picture.
  std::array<DrawCamera, 2> cameras() const {
    return {camera_of(eyes[0], 0, width, height), camera_of(eyes[1], width, width, height)};
  }
};

/// A line about what happened: shown to the wearer, too, or for who reads the terminal alone.
struct HeadsetNews {
  std::string line;
  bool for_wearer = false;
};

/// Tells whether the runtime takes pictures by EGL, and not by GLX alone; true where none answers. Throws
/// InputError where there is no loader.
bool headset_takes_egl();

class Headset {
 public:
  /// Looks for the headset. `context` draws, and outlives this; `room_stage` is the pose of the headset's
  /// stage in the room. Throws InputError where there is no loader, no runtime, or none that fits; a headset
  /// that isn't connected is waited for. A thread of its own calls `take_user` with the user as they are, in
  /// the room, however long pictures take.
  Headset(const GlContext& context, const Pose& room_stage,
          std::function<void(const TrackedUser& user)> take_user);
  ~Headset();

  /// Goes on to the next frame, for which it waits. Returns it where a picture is wanted: then show() must
  /// follow.
  std::optional<HeadsetFrame> next_frame();
  /// Shows the picture that `draw` copies into the texture, of both eyes side by side.
  void show(const std::function<void(unsigned texture)>& draw);
  /// Tells whether next_frame() kept the headset's rhythm: false where it has none now.
  bool keeps_time() const { return keeps_time_; }
  /// Returns the rhythm of all frames until now.
  const FramePacing& pacing() const { return pacing_; }
  /// Tells whether the headset's own menu ended the program.
  bool closed() const { return closed_; }
  /// Returns what happened since the last call.
  std::vector<HeadsetNews> take_news() { return std::exchange(news_, {}); }

 private:
  struct Parts;  // what knows OpenXR

  const GlContext& context_;
  Pose room_stage_;
  std::function<void(const TrackedUser& user)> take_user_;
  std::mutex mutex_;              // of the parts' being there, and of what the runtime says of hands
  std::unique_ptr<Parts> parts_;  // null: lost, or not yet there
  std::int64_t tried_ns_ = 0;
  std::string reason_;  // for which it isn't there, as last told
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
