#include "twins/camera/sensor.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

namespace prosector {
namespace {

/// Returns a table of standard normal numbers, computed once. Each row of an image starts at a random index.
const std::vector<float>& normal_numbers() {
  static const std::vector<float> numbers = [] {
    std::mt19937 random(20261127);
    std::vector<float> out((1 << 16) + 1);
    for (std::size_t i = 0; i + 1 < out.size(); i += 2) {  // Box and Muller 1958
      const double u = (static_cast<double>(random()) + 1) / 4294967297.0;
      const double v = static_cast<double>(random()) / 4294967296.0 * 2 * CV_PI;
      const double r = std::sqrt(-2 * std::log(u));
      out[i] = static_cast<float>(r * std::cos(v));
      out[i + 1] = static_cast<float>(r * std::sin(v));
    }
    return out;
  }();
  return numbers;
}

cv::Mat compressed(const cv::Mat& bgr, int quality) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

}  // namespace

Image expose(const Sensor& sensor, int width, int height, std::vector<Rgb> light, std::uint64_t number) {
  cv::Mat picture(height, width, CV_32FC3, light.data());
  if (sensor.blur > 0) cv::GaussianBlur(picture, picture, {0, 0}, sensor.blur, 0, cv::BORDER_REPLICATE);
  const Response response(sensor.response);
  const std::vector<float>& normal = normal_numbers();
  std::mt19937 random(sensor.seed ^ static_cast<unsigned>(number * 2654435761u));
  Image out{width, height, {}};
  out.rgb.resize(3 * light.size());
  std::size_t byte = 0;
  for (int y = 0; y < height; ++y) {
    const auto* row = picture.ptr<float>(y);
    std::size_t at = random();
    for (int k = 0; k < 3 * width; ++k) {
      const float lit = response.byte(static_cast<float>(sensor.light) * row[k]);
      const float noisy = lit + static_cast<float>(sensor.noise) * normal[++at & 0xffff];
      out.rgb[byte++] = static_cast<std::uint8_t>(std::clamp(noisy + 0.5f, 0.0f, 255.0f));
    }
  }
  if (sensor.jpeg > 0) {
    const cv::Mat rgb(height, width, CV_8UC3, out.rgb.data());
    cv::Mat bgr;
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    cv::cvtColor(compressed(bgr, sensor.jpeg), rgb, cv::COLOR_BGR2RGB);
  }
  return out;
}

}  // namespace prosector
