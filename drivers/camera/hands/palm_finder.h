#pragma once
// Finds palms in a whole picture, by a network that looks at all of it at once.

#include "drivers/camera/hands/network.h"
#include "drivers/camera/hands/picture_region.h"

namespace prosector {

struct FoundPalm {
  double score = 0;      // 0 to 1
  Vec2 low, high;        // its box, pixels
  PictureRegion region;  // of the whole hand, fingers up
};

class PalmFinder {
 public:
  /// Throws InputError where it is another network.
  explicit PalmFinder(NetPlan plan);
  /// Returns palms that don't overlap, the surest first.
  std::vector<FoundPalm> find(const Image& image);

 private:
  Network network_;
  std::vector<Vec2> anchors_;  // where each answer of the network belongs, 0 to 1
};

/// Returns how much of what two boxes cover together they both cover.
double overlap(const FoundPalm& a, const FoundPalm& b);

}  // namespace prosector
