#include "twins/camera/texture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

namespace prosector {
namespace {

std::size_t index(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

}  // namespace

Response::Response(double exponent) : exponent_(exponent) {
  for (std::size_t i = 0; i < light_.size(); ++i)
    light_[i] = static_cast<float>(std::pow(static_cast<double>(i) / 255, exponent));
}

float Response::byte(float light) const {
  const float bounded = std::clamp(light, 0.0f, 1.0f);
  return 255 * (exponent_ == 1 ? bounded : std::pow(bounded, static_cast<float>(1 / exponent_)));
}

Texture::Texture(const Image& image, bool smooth, const Response& response) : smooth_(smooth) {
  Level first{image.width, image.height, {}};
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    first.pixels.push_back(
        {response.light(image.rgb[i]), response.light(image.rgb[i + 1]), response.light(image.rgb[i + 2])});
  levels_.push_back(std::move(first));
  while (smooth && std::min(levels_.back().width, levels_.back().height) >= 2) {
    const Level& fine = levels_.back();
    Level coarse{fine.width / 2, fine.height / 2, {}};
    for (int y = 0; y < coarse.height; ++y)
      for (int x = 0; x < coarse.width; ++x) {
        Rgb sum{};
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
          for (std::size_t c = 0; c < 3; ++c) sum[c] += fine.pixel(2 * x + i, 2 * y + j)[c] / 4;
        coarse.pixels.push_back(sum);
      }
    levels_.push_back(std::move(coarse));
  }
}

std::size_t Texture::level(double ratio) const {
  const double level = std::floor(std::log2(std::max(1.0, ratio)));
  return std::min(static_cast<std::size_t>(level), levels_.size() - 1);
}

const Rgb& Texture::Level::pixel(int x, int y) const {
  return pixels[index(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1), width)];
}

Rgb Texture::at(float u, float v, std::size_t level) const {
  const Level& pixels = levels_[level];
  const float x = u * static_cast<float>(pixels.width), y = v * static_cast<float>(pixels.height);
  if (!smooth_) return pixels.pixel(static_cast<int>(x), static_cast<int>(y));
  const float fx = std::floor(x - 0.5f), fy = std::floor(y - 0.5f);
  const float a = x - 0.5f - fx, b = y - 0.5f - fy;
  const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
  const Rgb &p = pixels.pixel(ix, iy), &q = pixels.pixel(ix + 1, iy), &r = pixels.pixel(ix, iy + 1),
            &s = pixels.pixel(ix + 1, iy + 1);
  Rgb out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = (1 - b) * ((1 - a) * p[c] + a * q[c]) + b * ((1 - a) * r[c] + a * s[c]);
  return out;
}

Image wood(int side, unsigned seed) {
  std::mt19937 random(seed);
  cv::Mat sum(side, side, CV_32F, cv::Scalar(0));
  // Sums octaves of noise, each stretched along the grain.
  for (int cells = 4; cells <= side / 2; cells *= 2) {
    cv::Mat octave(cells, std::max(1, cells / 4), CV_32F);
    for (int y = 0; y < octave.rows; ++y)
      for (int x = 0; x < octave.cols; ++x)
        octave.at<float>(y, x) = static_cast<float>(random() % 2001) / 1000.0f - 1.0f;
    cv::Mat grown;
    cv::resize(octave, grown, sum.size(), 0, 0, cv::INTER_CUBIC);
    sum += grown * (0.5 / std::sqrt(static_cast<double>(cells)));
  }
  Image out{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float lit = 1 + sum.at<float>(y, x);
      for (const float base : {150.0f, 112.0f, 78.0f})
        out.rgb.push_back(static_cast<std::uint8_t>(std::clamp(base * lit, 0.0f, 255.0f)));
    }
  return out;
}

}  // namespace prosector
