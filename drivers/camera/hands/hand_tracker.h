#pragma once
// Tracks both bare hands in the images of one or two cameras: detection, fit and smoothing.

#include <array>

#include "common/ids.h"
#include "drivers/camera/base/frame.h"
#include "drivers/camera/base/one_euro.h"
#include "drivers/camera/hands/hand_finder.h"
#include "drivers/camera/hands/hand_fit.h"
#include "drivers/camera/hands/jump_filter.h"

namespace prosector {

/// Lens and pose of a camera.
struct CameraSetup {
  Lens lens;
  Pose camera_rig;  // pose of the first camera's frame in this camera's frame; the identity for the first
                    // camera
};

struct TrackedHand {
  std::size_t hand = right_hand;
  Pose wrist;  // in the first camera's frame (x right, y down, z forward)
  std::array<double, fingers> flexion{};
  double miss = 0;          // as in HandFit
  std::size_t cameras = 1;  // number of cameras that saw the hand
};

/// Hand size and range of the tracked user.
struct TrackedUser {
  double size = 1;                       // of the hands, as a factor of the hand model
  double farthest = default_hand_range;  // m from the camera; hands farther away are bystanders'
};

class HandTracker {
 public:
  /// Loads the networks from the folder `nets`. Throws InputError with advice on how to get the files.
  HandTracker(const std::filesystem::path& nets, HandNets effort, std::size_t cameras,
              const TrackedUser& user = {});

  /// Sets the lens and pose of a camera; call it before its first image.
  void set_camera_setup(std::size_t camera, const CameraSetup& eye);
  /// Processes an image of a camera. Returns the hands with a reliable pose.
  std::vector<TrackedHand> see(std::size_t camera, const Frame& frame);

  /// Returns the likely reason why the last image gave no hand; empty: it gave one.
  const char* lack() const { return lack_; }

 private:
  struct Seen {
    std::int64_t time_ns = 0;
    HandPoints points;
    HandDepths depths;
  };
  struct Camera {
    HandFinder finder;
    CameraSetup eye;
    std::array<std::optional<Seen>, 2> hands;  // newest detections: left and right hand
  };
  /// State of a hand between images.
  struct HandTrack {
    std::optional<HandFit> before;
    std::int64_t time_ns = 0;
    JumpFilter doubt;
    PoseFilter filter;
    std::array<double, fingers> bends{}, speeds{};  // smoothed bends, 0 to 1; their speeds, 1/s
  };

  void note(Camera& camera, const Frame& frame);
  bool leads(std::size_t camera, std::size_t hand, std::int64_t now_ns) const;
  std::optional<TrackedHand> fit(std::size_t camera, std::size_t hand, std::int64_t now_ns);
  static void smooth(HandTrack& way, const std::array<double, fingers>& flexion, double seconds);

  TrackedUser user_;
  const char* lack_ = "";
  std::vector<Camera> cameras_;
  std::array<HandTrack, 2> tracks_;
};

}  // namespace prosector
