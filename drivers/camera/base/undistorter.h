#pragma once
// Removes a lens' distortion from whole images. The result is the image of a pinhole camera, in which
// straight edges are straight.

#include <memory>

#include "drivers/camera/base/grey_image.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

class Undistorter {
 public:
  /// Prepares the removal of a lens' distortion from images. The undistorted image has the lens' scale at its
  /// centre. It is larger than the distorted image where needed to show its corners, by the factor
  /// `max_enlargement` at most.
  explicit Undistorter(const Lens& lens);
  ~Undistorter();

  static constexpr double max_enlargement = 1.3;

  /// Returns the image with the lens' distortion removed, interpolated linearly. The distorted image `bent`
  /// must have the size that the lens states.
  GreyImage straight(const GreyImage& bent) const;
  Image straight(const Image& bent) const;
  /// Returns the lens of the undistorted images: that of a pinhole camera.
  const Lens& lens() const { return straight_; }

 private:
  struct Map;
  Lens straight_;
  std::unique_ptr<Map> map_;
};

}  // namespace prosector
