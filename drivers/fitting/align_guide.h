#pragma once
// Guides a user holding a board on a tracker's receiver in front of a camera. The result is the camera's pose
// in the tracker's frame.

#include <array>

#include "drivers/camera/calibration/tracker_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/stillness_detector.h"

namespace prosector {

class AlignGuide final : public Guide {
 public:
  /// Starts a guided calibration of a camera's pose in a tracker's frame. It collects `poses` poses at which
  /// the board and the receiver `station` (index from 0) are held still.
  AlignGuide(std::size_t station, std::size_t poses);

  void take(const DeviceSample& sample) override;
  /// Adds the board's pose that the camera detected at `time_ns`: m, camera frame in OpenCV's convention (x
  /// right, y down, z forward).
  void add_board_pose(std::int64_t time_ns, const Pose& camera_board);
  /// Returns whether the tracker has reported a pose of the receiver since the guide started.
  bool has_tracker_pose() const { return tracked_ns_ > 0; }
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;

 private:
  bool is_new(const Pose& camera_board) const;

  std::size_t station_, poses_;
  StillnessDetector tracker_, camera_;
  std::int64_t tracked_ns_ = 0;  // time of the newest tracker pose
  std::int64_t still_ns_ = 0;    // time since which both are still; 0: not still
  std::vector<TrackedPair> pairs_;
  std::string rejection_;
};

}  // namespace prosector
