#include "drivers/camera/base/undistorter.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace prosector {
namespace {

/// Returns the pinhole lens that covers the lens' field of view, with whole pixels for the principal point.
Lens pinhole_for(const Lens& lens) {
  double left = 0, right = 0, up = 0, down = 0;  // pixels from the principal point
  const auto reach = [&](double x, double y) {
    const Vec3 ray = lens.ray({x, y});
    left = std::max(left, -ray.x() * lens.fx);
    right = std::max(right, ray.x() * lens.fx);
    up = std::max(up, -ray.y() * lens.fy);
    down = std::max(down, ray.y() * lens.fy);
  };
  constexpr int samples = 16;  // per side
  for (int k = 0; k <= samples; ++k) {
    const double x = k * (lens.width - 1.0) / samples, y = k * (lens.height - 1.0) / samples;
    reach(x, 0);
    reach(x, lens.height - 1.0);
    reach(0, y);
    reach(lens.width - 1.0, y);
  }
  const auto bounded = [](double reached, double side) {
    return std::clamp(std::ceil(reached), 1.0, std::ceil(Undistorter::max_enlargement * side));
  };
  Lens out;
  out.fx = lens.fx;
  out.fy = lens.fy;
  out.cx = bounded(left, std::max(1.0, lens.cx));
  out.cy = bounded(up, std::max(1.0, lens.cy));
  out.width = static_cast<int>(out.cx + bounded(right, std::max(1.0, lens.width - 1 - lens.cx))) + 1;
  out.height = static_cast<int>(out.cy + bounded(down, std::max(1.0, lens.height - 1 - lens.cy))) + 1;
  return out;
}

template <class Byte>
cv::Mat wrapped(int width, int height, int type, Byte* bytes) {
  return {height, width, type, const_cast<std::uint8_t*>(bytes)};
}

}  // namespace

struct Undistorter::Map {
  cv::Mat coarse, fine;  // OpenCV's fixed-point map of pixels
};

Undistorter::Undistorter(const Lens& lens) : straight_(pinhole_for(lens)), map_(std::make_unique<Map>()) {
  cv::Mat from(straight_.height, straight_.width, CV_32FC2);
  for (int y = 0; y < straight_.height; ++y)
    for (int x = 0; x < straight_.width; ++x) {
      const Vec2 pixel = lens.project(straight_.ray({x, y}));
      from.at<cv::Vec2f>(y, x) = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
    }
  cv::convertMaps(from, cv::noArray(), map_->coarse, map_->fine, CV_16SC2);
}

Undistorter::~Undistorter() = default;

GreyImage Undistorter::straight(const GreyImage& bent) const {
  GreyImage out{straight_.width, straight_.height, {}};
  out.grey.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  cv::Mat into = wrapped(out.width, out.height, CV_8UC1, out.grey.data());
  cv::remap(wrapped(bent.width, bent.height, CV_8UC1, bent.grey.data()), into, map_->coarse, map_->fine,
            cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

Image Undistorter::straight(const Image& bent) const {
  Image out{straight_.width, straight_.height, {}};
  out.rgb.resize(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  cv::Mat into = wrapped(out.width, out.height, CV_8UC3, out.rgb.data());
  cv::remap(wrapped(bent.width, bent.height, CV_8UC3, bent.rgb.data()), into, map_->coarse, map_->fine,
            cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

}  // namespace prosector
