#pragma once
// Undoes a lens' distortion in whole pictures, so that straight edges are straight and a plain pinhole
// remains.

#include <memory>

#include "drivers/camera/grey_image.h"
#include "drivers/camera/lens.h"

namespace prosector {

class Straightener {
 public:
  /// Makes it for a lens' pictures. The straight picture has the lens' scale in its middle; it is larger than
  /// the bent one, at most by `most_growth`, where that shows what the corners saw.
  explicit Straightener(const Lens& lens);
  ~Straightener();

  static constexpr double most_growth = 1.3;

  /// Returns the straight picture, interpolated linearly. The picture must have the lens' size.
  GreyImage straight(const GreyImage& bent) const;
  Image straight(const Image& bent) const;
  /// Returns the straight pictures' lens, without distortion.
  const Lens& lens() const { return straight_; }

 private:
  struct Map;
  Lens straight_;
  std::unique_ptr<Map> map_;
};

}  // namespace prosector
