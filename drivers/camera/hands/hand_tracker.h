#pragma once
// Both bare hands, out of the pictures of one or two cameras: found, fitted, smoothed.

#include <array>

#include "drivers/camera/frame.h"
#include "drivers/camera/hands/hand_finder.h"
#include "drivers/camera/hands/hand_fit.h"
#include "drivers/camera/hands/pose_doubt.h"
#include "drivers/camera/one_euro.h"

namespace prosector {

/// How a camera looks.
struct HandEye {
  Lens lens;
  Pose camera_rig;  // the first camera's frame in this one's; the first: none
};

struct TrackedHand {
  std::size_t hand = right_hand;
  Pose wrist;  // in the first camera's frame (x right, y down, z ahead)
  std::array<double, fingers> flexion{};
  double miss = 0;          // as HandFit says it
  std::size_t cameras = 1;  // that saw it
};

/// Whose hands are tracked.
struct TrackedUser {
  double size = 1;                     // of the hands: 1 is our hand
  double farthest = usual_hand_range;  // m from the camera: hands beyond it are bystanders'
};

class HandTracker {
 public:
  /// Takes the networks from this folder. Throws InputError that says how to get them.
  HandTracker(const std::filesystem::path& nets, HandNets effort, std::size_t cameras,
              const TrackedUser& user = {});

  /// Says how a camera looks from now on, before its first picture.
  void set_eye(std::size_t camera, const HandEye& eye);
  /// Takes a camera's picture. Returns the hands of which it makes sure poses: what isn't sure is left out.
  std::vector<TrackedHand> see(std::size_t camera, const Frame& frame);

  /// Returns why the last picture gave no hand, as well as it is known; empty: it gave one.
  const char* lack() const { return lack_; }

 private:
  struct Seen {
    std::int64_t time_ns = 0;
    HandPoints points;
    HandDepths depths;
  };
  struct Camera {
    HandFinder finder;
    HandEye eye;
    std::array<std::optional<Seen>, 2> hands;  // newest, left and right
  };
  /// A hand's way so far.
  struct Way {
    std::optional<HandFit> before;
    std::int64_t time_ns = 0;
    PoseDoubt doubt;
    PoseFilter filter;
    std::array<double, fingers> bends{}, speeds{};  // smoothed; 1/s
  };

  void note(Camera& camera, const Frame& frame);
  bool leads(std::size_t camera, std::size_t hand, std::int64_t now_ns) const;
  std::optional<TrackedHand> fit(std::size_t camera, std::size_t hand, std::int64_t now_ns);
  static void smooth(Way& way, const std::array<double, fingers>& flexion, double seconds);

  TrackedUser user_;
  const char* lack_ = "";
  std::vector<Camera> cameras_;
  std::array<Way, 2> ways_;
};

}  // namespace prosector
