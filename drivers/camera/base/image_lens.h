#pragma once
// Lens used to process images: from a file, from the camera, or guessed.

#include <filesystem>
#include <optional>

#include "drivers/camera/base/camera_calibration.h"

namespace prosector {

class ImageLens {
 public:
  /// Reads the lens file. If `file` is empty, the lens is the camera's own or guessed. Throws InputError if
  /// the file can't be read.
  explicit ImageLens(const std::filesystem::path& file);

  /// Resets the lens for a newly opened camera.
  void begin(const Camera& camera);
  /// Adapts the lens to the image's size. Returns whether the lens changed.
  bool take(const Image& image);
  /// Returns the lens, scaled to the size of the last image.
  const Lens& lens() const { return lens_; }
  bool is_guessed() const { return !calibration_; }

 private:
  bool from_file_ = false;
  std::optional<CameraCalibration> calibration_;
  Lens lens_;
  int width_ = 0, height_ = 0;  // size of the last image, pixels
};

}  // namespace prosector
