#pragma once
// Lens used to process images: from a file, from the camera, or guessed.

#include <filesystem>
#include <optional>

#include "drivers/camera/base/camera_calibration.h"

namespace prosector {

class ImageLens {
 public:
  /// Reads the camera's calibration from `file`. If `file` is empty, the lens is the one that the camera
  /// itself states, or a guessed one. Throws InputError if the file cannot be read.
  explicit ImageLens(const std::filesystem::path& file);

  /// Prepares for the images of a newly opened camera. If the lens does not come from a file, it is replaced
  /// with the one that this camera states, or a guessed one.
  void begin(const Camera& camera);
  /// Scales the lens to the image's size. Returns whether the lens changed, because the size differs from
  /// that of the previous image.
  bool take(const Image& image);
  /// Returns the camera's lens, scaled to the size of the last image.
  const Lens& lens() const { return lens_; }
  bool is_guessed() const { return !calibration_; }

 private:
  bool from_file_ = false;
  std::optional<CameraCalibration> calibration_;
  Lens lens_;
  int width_ = 0, height_ = 0;  // size of the last image, pixels
};

}  // namespace prosector
