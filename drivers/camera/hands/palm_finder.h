#pragma once
// Finds palms in a whole picture.

#include "drivers/camera/hands/anchor_network.h"

namespace prosector {

class PalmFinder {
 public:
  /// Throws InputError where it is another network.
  explicit PalmFinder(NetPlan plan);
  /// Returns squares around whole hands, fingers up, the surest first. Who asks looks closer: some hold none.
  std::vector<PictureRegion> find(const Image& image);

 private:
  AnchorNetwork network_;
};

}  // namespace prosector
