#include "drivers/camera/picture_file.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t most_pixels = 1 << 26;

}  // namespace

Image read_picture(const std::filesystem::path& file) {
  const cv::Mat read = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (read.empty()) throw InputError(fmt::format("{}: is no picture that can be read", file.string()));
  if (read.total() > most_pixels)
    throw InputError(fmt::format("{}: has more than {} pixels", file.string(), most_pixels));
  cv::Mat rgb;
  cv::cvtColor(read, rgb, cv::COLOR_BGR2RGB);
  Image out{rgb.cols, rgb.rows, {}};
  out.rgb.assign(rgb.datastart, rgb.dataend);
  return out;
}

}  // namespace prosector
