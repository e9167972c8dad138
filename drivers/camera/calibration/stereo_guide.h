#pragma once
// Leads a person through the calibration of two cameras at once: both lenses, and how they stand to each
// other, by one board.

#include <array>

#include "drivers/camera/calibration/lens_guide.h"
#include "drivers/camera/calibration/stereo_fit.h"

namespace prosector {

struct StereoGuideStep {
  std::string instruction;                // what to do now
  std::array<std::size_t, 2> views = {};  // that are kept of each camera
  std::size_t pairs = 0;                  // that both see
  bool done = false;
};

class StereoGuide {
 public:
  /// Begins. Throws InputError where the board has no tags.
  explicit StereoGuide(const Board& board) : guides_{LensGuide(board), LensGuide(board)} {}

  /// Takes a picture of the first camera (0) or the second one (1).
  void take(std::size_t camera, const Frame& frame);
  StereoGuideStep step() const;
  const LensGuide& of(std::size_t camera) const { return guides_[camera]; }
  const std::vector<StereoPair>& pairs() const { return pairs_; }

  static constexpr double most_apart = 0.05;  // s between two pictures of a pair

 private:
  /// The last picture of a camera.
  struct Newest {
    std::int64_t time_ns = 0;
    std::size_t kept = 0;  // views of its guide
  };

  std::array<LensGuide, 2> guides_;
  std::array<Newest, 2> newest_;
  std::size_t kept_ = 0;  // views of both guides when the last pair was kept
  bool apart_ = false;    // the board rests before both, but their pictures are too far apart
  std::vector<StereoPair> pairs_;
};

}  // namespace prosector
