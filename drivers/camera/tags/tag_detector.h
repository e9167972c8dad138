#pragma once
// Detects tags of the family 36h11 in undistorted images with libapriltag (Krogius, Haggenmiller and Olson
// 2019).

#include <array>
#include <memory>
#include <vector>

#include "drivers/camera/base/grey_image.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

/// A tag (square fiducial marker of the family 36h11) detected in an image: its code and the pixels of its
/// corners.
struct DetectedTag {
  int code = 0;
  std::array<Vec2, 4> corners;  // pixels; black square's lower left, lower right, upper right, upper left
  double margin = 0;            // decision margin of the bits; detections below 20 were rejected
};

struct TagDetectorSettings {
  double decimate =
      2;  // factor by which the image is reduced for the quad search; 1 reaches farther and takes longer.
          // Images of at most `undecimated_pixels` always use 1, which costs little there
};

inline constexpr int undecimated_pixels = 400 * 300;

class TagDetector {
 public:
  explicit TagDetector(const TagDetectorSettings& settings);
  ~TagDetector();

  /// Detects tags in an undistorted image. Returns them sorted by code. A code that is printed twice may
  /// appear twice.
  std::vector<DetectedTag> find(const GreyImage& straight) const;

 private:
  struct Detector;
  TagDetectorSettings settings_;
  std::unique_ptr<Detector> detector_;
};

}  // namespace prosector
