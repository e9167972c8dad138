#include "drivers/camera/base/image_reader.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "common/error.h"

namespace prosector {

std::optional<Image> try_read_image(const std::filesystem::path& file) {
  cv::Mat read;
  try {
    read = cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return std::nullopt;  // OpenCV throws for a header with an impossible number of pixels
  }
  if (read.empty()) return std::nullopt;
  if (read.total() > max_image_pixels)
    throw InputError(fmt::format("{}: has more than {} pixels", file.string(), max_image_pixels));
  cv::Mat rgb;
  cv::cvtColor(read, rgb, cv::COLOR_BGR2RGB);
  Image out{rgb.cols, rgb.rows, {}};
  out.rgb.assign(rgb.datastart, rgb.dataend);
  return out;
}

Image read_image(const std::filesystem::path& file) {
  if (auto image = try_read_image(file)) return *std::move(image);
  throw InputError(fmt::format("{}: not a readable image", file.string()));
}

}  // namespace prosector
