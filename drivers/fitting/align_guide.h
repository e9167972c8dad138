#pragma once
// Guides a person who holds a board on a tracker's receiver before a camera, so that the camera's place in
// the tracker's frame is found.

#include <array>

#include "drivers/camera/calibration/tracker_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/still_window.h"

namespace prosector {

class AlignGuide final : public Guide {
 public:
  /// Takes so many poses of a receiver (from 0).
  AlignGuide(std::size_t station, std::size_t poses);

  void take(const DeviceSample& sample) override;
  /// Takes where the camera (OpenCV's frame) sees the board.
  void take_board(std::int64_t time_ns, const Pose& camera_board);
  /// Tells whether the tracker has told a pose.
  bool has_tracker() const { return tracked_ns_ > 0; }
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;

 private:
  bool is_new(const Pose& camera_board) const;

  std::size_t station_, poses_;
  StillWindow tracker_, camera_;
  std::int64_t tracked_ns_ = 0;  // of the newest pose
  std::int64_t still_ns_ = 0;    // since when both are held still; 0: they aren't
  std::vector<TrackedPair> pairs_;
  std::string trouble_;
};

}  // namespace prosector
