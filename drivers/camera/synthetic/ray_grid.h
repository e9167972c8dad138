#pragma once
// Where a synthetic camera's pixels look, and when: several rays a pixel, each at its own moment of the
// exposure.

#include <vector>

#include "drivers/camera/lens.h"

namespace prosector {

/// How a picture is exposed.
struct Exposure {
  double middle = 0;   // s, of the middle row
  double length = 0;   // s
  double readout = 0;  // s from the first row to the last: a rolling shutter; 0: all at once
};

class RayGrid {
 public:
  /// Makes it with so many rays a pixel's side; a pixel has the square of it.
  RayGrid(const Lens& lens, int side);

  const Lens& lens() const { return lens_; }
  std::size_t rays() const { return offsets_.size(); }
  /// Returns the direction (a, b) of a pixel's ray, interpolated between the pixel's corners.
  Eigen::Vector2f direction(int x, int y, std::size_t ray) const;
  /// Returns a ray's moment in a row, s. Neighbouring rays have moments far apart.
  double moment(const Exposure& exposure, int y, std::size_t ray) const;

 private:
  struct Offset {
    float x, y;   // in the pixel, from 0 to 1
    double when;  // in the exposure, from −½ to ½
  };

  Lens lens_;
  std::vector<Offset> offsets_;
  std::vector<Eigen::Vector2f>
      corners_;  // directions of pixels' corners, a row more and a column more than pixels
};

}  // namespace prosector
