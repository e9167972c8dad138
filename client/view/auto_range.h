#pragma once
// Upper end of a colour scale that follows the values shown.

#include <vector>

namespace prosector {

/// Ends are 1, 2 or 5 times a power of ten. The end rises as soon as values exceed it, and falls only when
/// they are well below the next smaller end, so that colours don't flicker.
class AutoRange {
 public:
  /// Uses no end below `least`.
  explicit AutoRange(double least) : least_(least), end_(least) {}

  /// Takes all values of a frame, in any order; those that are not finite are ignored. Returns the scale's
  /// end for them. It is at least a third of the largest value, and at least as large as 99 % of the values.
  double follow(std::vector<double> values);

 private:
  double least_, end_;
};

}  // namespace prosector
