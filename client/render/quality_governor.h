#pragma once
// Selects the quality level by frame time.

#include <cstddef>

#include "client/render/renderer.h"

namespace prosector {

/// Controller of the rendering quality level by measured frame times. It lowers the level when the mean of 15
/// frame times exceeds the target. It raises the level when the mean stays below half the target, as the next
/// level costs up to twice as much. After a level proved too expensive, it waits longer before trying that
/// again, to avoid oscillation.
class QualityGovernor {
 public:
  /// Sets the target frame time, s; throws InputError unless it is above 0. The first level is medium.
  explicit QualityGovernor(double target);

  /// Returns the quality level with which to render the next frame.
  const QualityLevel& level() const { return quality_levels[level_]; }
  /// Adds the time that the last frame took, s. Returns true if level() changed.
  bool took(double seconds);

 private:
  static constexpr int frames_per_judgement = 15;
  static constexpr int first_retry_delay = 4,
                       max_retry_delay = 1024;  // judgements before an expensive level is tried again

  double target_;
  std::size_t level_ = 1;  // medium
  int pictures_ = 0, fits_ = 0, retry_delay_ = first_retry_delay;
  double sum_ = 0;
};

}  // namespace prosector
