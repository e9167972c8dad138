#include "drivers/camera/picture_file.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "common/error.h"

namespace prosector {

std::optional<Image> try_picture(const std::filesystem::path& file) {
  cv::Mat read;
  try {
    read = cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return std::nullopt;  // as of a header that says more pixels than can be
  }
  if (read.empty()) return std::nullopt;
  if (read.total() > most_picture_pixels)
    throw InputError(fmt::format("{}: has more than {} pixels", file.string(), most_picture_pixels));
  cv::Mat rgb;
  cv::cvtColor(read, rgb, cv::COLOR_BGR2RGB);
  Image out{rgb.cols, rgb.rows, {}};
  out.rgb.assign(rgb.datastart, rgb.dataend);
  return out;
}

Image read_picture(const std::filesystem::path& file) {
  if (auto image = try_picture(file)) return *std::move(image);
  throw InputError(fmt::format("{}: is no picture that can be read", file.string()));
}

}  // namespace prosector
