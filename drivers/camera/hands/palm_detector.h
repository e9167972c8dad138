#pragma once
// Detects palms in a whole image.

#include "drivers/camera/nets/anchor_network.h"

namespace prosector {

class PalmDetector {
 public:
  /// Checks the network. Throws InputError if its inputs or outputs are not those of a palm detector.
  explicit PalmDetector(NetPlan plan);
  /// Returns squares around whole hands, fingers up, the highest score first. Some contain no hand; the
  /// caller must verify each.
  std::vector<ImageRegion> find(const Image& image);

 private:
  AnchorDetector network_;
};

}  // namespace prosector
