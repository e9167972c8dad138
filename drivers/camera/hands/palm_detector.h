#pragma once
// Detects palms in a whole image.

#include "drivers/camera/nets/anchor_network.h"

namespace prosector {

class PalmDetector {
 public:
  /// Prepares the network `plan` for palm detection. Throws InputError if its inputs or outputs are not those
  /// of a palm detector.
  explicit PalmDetector(NetPlan plan);
  /// Detects palms in the whole image. Returns squares around the whole hands, rotated so that the fingers
  /// point up, the highest score first. Some contain no hand; the caller must verify each.
  std::vector<ImageRegion> find(const Image& image);

 private:
  AnchorDetector network_;
};

}  // namespace prosector
