#pragma once
// Directions and times of a synthetic camera's rays: several rays per pixel, each at its own time within the
// exposure.

#include <vector>

#include "drivers/camera/base/lens.h"

namespace prosector {

/// Timing of the exposure of a synthetic camera's image, in scene time: middle, length, and readout time of a
/// rolling shutter.
struct Exposure {
  double middle = 0;   // s, mid-exposure of the middle row
  double length = 0;   // s
  double readout = 0;  // s from the first row to the last with a rolling shutter; 0: global shutter
};

class RayGrid {
 public:
  /// Creates side × side rays for each pixel of a synthetic camera with this lens.
  RayGrid(const Lens& lens, int side);

  const Lens& lens() const { return lens_; }
  std::size_t rays() const { return offsets_.size(); }
  /// Returns the direction (x/z, y/z) in the camera's frame of ray number `ray` of pixel (x, y). It is
  /// interpolated between the directions of the pixel's corners.
  Eigen::Vector2f direction(int x, int y, std::size_t ray) const;
  /// Returns the scene time, s, at which ray number `ray` of each pixel in row `y` samples the scene during
  /// the exposure. Neighbouring rays have distant times.
  double moment(const Exposure& exposure, int y, std::size_t ray) const;

 private:
  struct Offset {
    float x, y;   // position in the pixel, from 0 to 1
    double when;  // time as a share of the exposure, from −½ to ½
  };

  Lens lens_;
  std::vector<Offset> offsets_;
  std::vector<Eigen::Vector2f>
      corners_;  // directions of the pixels' corners: one row and one column more than pixels
};

}  // namespace prosector
