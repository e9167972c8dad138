#include "client/xr/eye_view.h"

#include <cmath>
#include <numbers>

namespace prosector {

bool is_usable(const EyeView& eye) {
  const auto ahead = [](double angle) { return std::abs(angle) < std::numbers::pi / 2; };  // false for NaN
  return is_finite(eye.pose) && ahead(eye.left) && ahead(eye.right) && ahead(eye.up) && ahead(eye.down) &&
         eye.left < eye.right && eye.down < eye.up;
}

DrawCamera camera_of(const EyeView& eye, int x, int width, int height) {
  DrawCamera out;
  out.pose = eye.pose;
  out.left = std::tan(eye.left);
  out.right = std::tan(eye.right);
  out.bottom = std::tan(eye.down);
  out.top = std::tan(eye.up);
  out.x = x;
  out.width = width;
  out.height = height;
  return out;
}

}  // namespace prosector
