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

/// Lens of one of several cameras, and the pose of the first camera's frame in this camera's frame.
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

/// Properties of the user whose hands are tracked: hand size, and distance beyond which hands are ignored.
struct TrackedUser {
  double size = 1;                       // of the hands, as a factor of the hand model
  double farthest = default_hand_range;  // m from the camera; hands farther away are bystanders'
};

class HandTracker {
 public:
  /// Loads the hand networks' files from the folder `nets`. `effort` selects the accurate or the fast
  /// networks; `cameras` is the number of cameras. Throws InputError with advice on how to get the files.
  HandTracker(const std::filesystem::path& nets, HandNets effort, std::size_t cameras,
              const TrackedUser& user = {});

  /// Sets the lens and the pose of camera number `camera` (from 0). Call it before this camera's first image.
  void set_camera_setup(std::size_t camera, const CameraSetup& eye);
  /// Processes an image of camera number `camera` (from 0). Returns the hands whose pose is reliable, with
  /// smoothed pose and flexions.
  std::vector<TrackedHand> see(std::size_t camera, const Frame& frame);

  /// Returns the likely reason, as a hint for the user, why the last image gave no hand; empty if it gave
  /// one.
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
  /// Tracking state of the left or the right hand between images: last fit, filters, and smoothed flexions.
  struct HandTrack {
    std::optional<HandFit> before;
    std::int64_t time_ns = 0;
    JumpFilter jump_filter;
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
