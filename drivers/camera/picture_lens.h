#pragma once
// The lens that pictures are reckoned by: from a file, the camera's own, or guessed.

#include <filesystem>
#include <optional>

#include "drivers/camera/camera_calibration.h"

namespace prosector {

class PictureLens {
 public:
  /// Reads the file; empty: the lens is the camera's own, or guessed. Throws InputError where it can't be
  /// read.
  explicit PictureLens(const std::filesystem::path& file);

  /// Takes a camera that was opened.
  void begin(const Camera& camera);
  /// Makes ready for a picture. Returns whether the lens is another one than before.
  bool take(const Image& image);
  /// Returns the lens, for pictures as large as the last one.
  const Lens& lens() const { return lens_; }
  bool is_guessed() const { return !calibration_; }

 private:
  bool from_file_ = false;
  std::optional<CameraCalibration> calibration_;
  Lens lens_;
  int width_ = 0, height_ = 0;  // of pictures so far
};

}  // namespace prosector
