#include "drivers/camera/tags/tag_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double shape_tolerance = 0.01;  // by which a picture's shape may differ from the calibrated one's

}  // namespace

TagReader::TagReader(const std::filesystem::path& lens)
    : is_calibrated_by_file_(!lens.empty()), finder_(TagFinderSettings{}) {
  if (is_calibrated_by_file_) calibration_ = load_calibration(lens);
}

void TagReader::begin(const Camera& camera) {
  number_.reset();
  if (is_calibrated_by_file_) return;
  const auto lens = camera.lens();
  const std::optional<Lens> before = calibration_ ? std::optional(calibration_->lens) : std::nullopt;
  if (lens != before) width_ = height_ = 0;
  calibration_.reset();
  if (lens) calibration_ = CameraCalibration{camera.identity(), *lens, camera.response(), 0};
}

void TagReader::make_ready(int width, int height) {
  if (width_ == width && height_ == height) return;
  const CameraCalibration known = calibration_.value_or(guessed_calibration(width, height));
  const double stretch =
      static_cast<double>(width) * known.lens.height / (static_cast<double>(height) * known.lens.width);
  if (std::abs(stretch - 1) > shape_tolerance)
    throw InputError(
        fmt::format("pictures are {} × {}, but the camera was calibrated with {} × {}: calibrate it anew, or "
                    "set it to that size",
                    width, height, known.lens.width, known.lens.height));
  optics_.bent = known.lens.scaled(width, height);
  optics_.response = known.response;
  straightener_ = std::make_unique<Straightener>(optics_.bent);
  optics_.straight = straightener_->lens();
  width_ = width;
  height_ = height;
  ++changes_;
}

const TagPicture& TagReader::read(const Frame& frame) {
  if (number_ == frame.number) return picture_;
  number_.reset();
  make_ready(frame.image.width, frame.image.height);
  picture_.bent = grey_of(frame.image);
  picture_.straight = straightener_->straight(picture_.bent);
  picture_.tags = finder_.find(picture_.straight);
  picture_.time_ns = frame.time_ns;
  number_ = frame.number;
  return picture_;
}

}  // namespace prosector
