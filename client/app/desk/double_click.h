#pragma once
// Detection of double clicks.

#include <chrono>

#include "common/math.h"

namespace prosector {

class DoubleClick {
 public:
  /// Handles a press of the button at a pixel of the frame. Returns whether it is the second press of a
  /// double click; otherwise it may be the first one.
  bool press(const Eigen::Vector2d& pixel) {
    const auto now = std::chrono::steady_clock::now();
    const bool second = now - last_ < max_interval && (pixel - last_pixel_).norm() < max_distance;
    last_ = second ? std::chrono::steady_clock::time_point() : now;
    last_pixel_ = pixel;
    return second;
  }

 private:
  static constexpr double max_distance = 6;  // pixels
  static constexpr std::chrono::milliseconds max_interval{350};

  std::chrono::steady_clock::time_point last_{};
  Eigen::Vector2d last_pixel_ = Eigen::Vector2d::Zero();
};

}  // namespace prosector
