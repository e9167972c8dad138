#pragma once
// Anchor-based object detector that processes a whole image in one run. Each output belongs to an anchor on a
// grid: score, bounding box and keypoints of an object.

#include <span>
#include <vector>

#include "drivers/camera/nets/image_region.h"
#include "drivers/camera/nets/network.h"

namespace prosector {

/// Input size of an anchor-based detector network, and the grids of its anchors, which are the default
/// positions of detected objects.
struct AnchorLayout {
  struct Grid {
    int side = 0;  // cells per side
    int each = 0;  // anchors per cell
  };
  std::size_t input = 0;         // pixels per side of the square input
  float darkest = 0;             // input value for black; 1 is white
  std::vector<Grid> grids = {};  // in the order of the outputs
  std::size_t points = 0;        // keypoints per detection
};

/// An object that a detector network found in an image: score, bounding box and keypoints, in pixels of the
/// image.
struct DetectedObject {
  double score = 0;  // 0 to 1
  Vec2 low, high;    // corners of the bounding box
  std::vector<Vec2> points;
};

/// Returns the area of the intersection of two objects' bounding boxes divided by the area of their union.
double overlap(const DetectedObject& a, const DetectedObject& b);

class AnchorDetector {
 public:
  /// Prepares the detector network `plan`. Throws InputError if its inputs or outputs differ from the layout.
  /// `what` names the detected objects in messages.
  AnchorDetector(NetPlan plan, AnchorLayout layout, const char* what);
  /// Detects objects in the whole image. Returns those with a score (0 to 1) of at least `least_score`, the
  /// highest first, without those that overlap a better one.
  std::vector<DetectedObject> find(const Image& image, double least_score);
  /// Detects objects in an unrotated square of the image only. Returns those with a score (0 to 1) of at
  /// least `least_score`, the highest first.
  std::vector<DetectedObject> find_in(const Image& image, const ImageRegion& square, double least_score);

 private:
  struct Answer {
    double score;
    Eigen::VectorXd
        values;  // as a share of the input's side: centre and size of the box, then x, y of the keypoints
  };
  std::vector<Answer> answers(double least_score) const;
  DetectedObject thing_of(const Answer& answer, const ImageRegion& square) const;

  AnchorLayout layout_;
  std::size_t values_;  // number of values per detection
  Network network_;
  std::vector<Vec2> anchors_;  // position of each anchor, 0 to 1
};

}  // namespace prosector
