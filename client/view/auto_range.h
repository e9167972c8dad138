#pragma once
// Upper limit of a colour scale that adapts to the displayed values.

#include <vector>

namespace prosector {

/// Adaptive upper limit of a colour scale: 1, 2 or 5 times a power of ten. It rises as soon as values exceed
/// it. It falls only when the values are well below the next smaller limit, so that colours don't flicker.
class AutoRange {
 public:
  /// Starts with the limit `least`, which is also the smallest limit that follow() returns.
  explicit AutoRange(double least) : least_(least), end_(least) {}

  /// Updates the upper limit of the colour scale from all values of a frame, in any order, and returns it.
  /// Ignores values that are not finite. The limit is at least a third of the largest value, and at least the
  /// 99th percentile.
  double follow(std::vector<double> values);

 private:
  double least_, end_;
};

}  // namespace prosector
