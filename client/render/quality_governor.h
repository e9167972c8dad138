#pragma once
// Picks the quality level whose pictures take no longer than they may.

#include <cstddef>

#include "client/render/renderer.h"

namespace prosector {

/// A choice of level, fed with what each picture took. It goes a level down when the mean of some pictures is
/// over the target. It goes up when the mean is so far below that the next level, which may cost twice as
/// much, should fit. A level that proved too dear is not tried again for a while, so that it does not swing.
class QualityGovernor {
 public:
  /// Takes the target, s a picture; throws InputError unless it is above 0.
  explicit QualityGovernor(double target);

  /// Returns the level to draw the next picture with.
  const QualityLevel& level() const { return quality_levels[level_]; }
  /// Takes what the last picture took, s. Returns true when the level changed.
  bool took(double seconds);

 private:
  static constexpr int pictures_judged = 15;
  static constexpr int first_patience = 4,
                       most_patience = 1024;  // judgements before a dear level is tried again

  double target_;
  std::size_t level_ = 1;  // medium
  int pictures_ = 0, fits_ = 0, patience_ = first_patience;
  double sum_ = 0;
};

}  // namespace prosector
