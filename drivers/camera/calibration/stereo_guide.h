#pragma once
// Guides a user through the calibration of two cameras with one board: both lenses, and the relative pose of
// the cameras.

#include <array>

#include "drivers/camera/calibration/lens_guide.h"
#include "drivers/camera/calibration/stereo_fit.h"

namespace prosector {

struct StereoGuideStep {
  std::string instruction;                // for the user, what to do now
  std::array<std::size_t, 2> views = {};  // number of views stored for each camera
  std::size_t pairs = 0;                  // number of pairs: views that both cameras share
  bool done = false;
};

class StereoGuide {
 public:
  /// Starts a guided calibration of two cameras with a printed board. Throws InputError if the board has no
  /// tags.
  explicit StereoGuide(const Board& board) : guides_{LensGuide(board), LensGuide(board)} {}

  /// Processes an image of one camera: `camera` is 0 for the first and 1 for the second. Stores a pair of
  /// views if the board is at rest in the newest images of both. These must be at most 50 ms apart, and the
  /// board's pose must be new to either camera.
  void take(std::size_t camera, const Frame& frame);
  StereoGuideStep step() const;
  const LensGuide& of(std::size_t camera) const { return guides_[camera]; }
  const std::vector<StereoPair>& pairs() const { return pairs_; }

  static constexpr double most_apart = 0.05;  // s, most between the two images of a pair

 private:
  /// Time of a camera's newest image, and the number of views that this camera's guide had stored after it.
  struct Newest {
    std::int64_t time_ns = 0;
    std::size_t kept = 0;  // number of views that the camera's guide has stored
  };

  std::array<LensGuide, 2> guides_;
  std::array<Newest, 2> newest_;
  std::size_t kept_ = 0;  // number of views in both guides when the last pair was stored
  bool apart_ = false;    // the board is at rest in both newest images, but these were taken too long apart
  std::vector<StereoPair> pairs_;
};

}  // namespace prosector
