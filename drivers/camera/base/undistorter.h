#pragma once
// Removes a lens' distortion from whole images. The result is the image of a pinhole camera, in which
// straight edges are straight.

#include <memory>

#include "drivers/camera/base/grey_image.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

class Undistorter {
 public:
  /// Prepares the maps for a lens. The undistorted image has the lens' scale at its centre. It is larger than
  /// the distorted image where needed to show its corners, at most by the factor `max_enlargement`.
  explicit Undistorter(const Lens& lens);
  ~Undistorter();

  static constexpr double max_enlargement = 1.3;

  /// Returns the undistorted image, with linear interpolation. The input must have the lens' size.
  GreyImage straight(const GreyImage& bent) const;
  Image straight(const Image& bent) const;
  /// Returns the lens of the undistorted images, without distortion.
  const Lens& lens() const { return straight_; }

 private:
  struct Map;
  Lens straight_;
  std::unique_ptr<Map> map_;
};

}  // namespace prosector
