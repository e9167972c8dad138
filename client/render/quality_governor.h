#pragma once
// Selects the quality level by frame time.

#include <cstddef>

#include "client/render/renderer.h"

namespace prosector {

/// Selects a quality level from measured frame times. Steps down when the mean of some frames exceeds the
/// target. Steps up when the mean is so low that the next level, at up to twice the cost, should fit. After a
/// level proved too expensive, waits longer before trying it again, to avoid oscillation.
class QualityGovernor {
 public:
  /// Sets the target, s per frame; throws InputError unless it is above 0.
  explicit QualityGovernor(double target);

  /// Returns the level for the next frame.
  const QualityLevel& level() const { return quality_levels[level_]; }
  /// Adds the duration of the last frame, s. Returns true if the level changed.
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
