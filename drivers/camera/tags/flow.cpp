#include "drivers/camera/tags/flow.h"

#include <opencv2/video/tracking.hpp>

#include "drivers/camera/base/with_cv.h"

namespace prosector {
namespace {

constexpr int window_side = 15;  // pixels
constexpr int pyramid_levels = 3;
constexpr double max_backward_error_px = 0.7;  // pixels, largest error after tracking a point forth and back

}  // namespace

std::vector<std::optional<Vec2>> follow_places(const GreyImage& from, const GreyImage& to,
                                               std::span<const Vec2> places) {
  std::vector<std::optional<Vec2>> out(places.size());
  if (places.empty()) return out;
  std::vector<cv::Point2f> starts, ends, back;
  for (const Vec2& place : places)
    starts.emplace_back(static_cast<float>(place.x()), static_cast<float>(place.y()));
  const cv::Size window(window_side, window_side);
  std::vector<cv::Mat> before, now;
  cv::buildOpticalFlowPyramid(matrix_of(from), before, window, pyramid_levels);
  cv::buildOpticalFlowPyramid(matrix_of(to), now, window, pyramid_levels);
  std::vector<std::uint8_t> found, found_back;
  cv::calcOpticalFlowPyrLK(before, now, starts, ends, found, cv::noArray(), window, pyramid_levels);
  cv::calcOpticalFlowPyrLK(now, before, ends, back, found_back, cv::noArray(), window, pyramid_levels);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (found[i] != 0 && found_back[i] != 0 && cv::norm(back[i] - starts[i]) < max_backward_error_px)
      out[i] = Vec2(ends[i].x, ends[i].y);
  return out;
}

}  // namespace prosector
