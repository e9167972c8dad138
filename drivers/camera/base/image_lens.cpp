#include "drivers/camera/base/image_lens.h"

namespace prosector {

ImageLens::ImageLens(const std::filesystem::path& file) {
  if (file.empty()) return;
  calibration_ = load_calibration(file);
  from_file_ = true;
}

void ImageLens::begin(const Camera& camera) {
  width_ = height_ = 0;
  if (from_file_) return;
  calibration_.reset();
  if (const auto lens = camera.lens())
    calibration_ = CameraCalibration{camera.identity(), *lens, camera.response(), 0};
}

bool ImageLens::take(const Image& image) {
  if (width_ == image.width && height_ == image.height) return false;
  width_ = image.width;
  height_ = image.height;
  lens_ = calibration_.value_or(guessed_calibration(width_, height_)).lens.scaled(width_, height_);
  return true;
}

}  // namespace prosector
