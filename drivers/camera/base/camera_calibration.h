#pragma once
// Calibration of one camera, and its file format.

#include <filesystem>
#include <string>

#include "drivers/camera/base/camera.h"

namespace prosector {

struct CameraCalibration {
  std::string camera;  // identity of the camera
  Lens lens;
  double response = default_response;
  double error = 0;  // pixels RMS, over views that weren't fitted
};

/// Returns a guessed calibration of a camera whose images have this size in pixels. It assumes a horizontal
/// field of view of 60° and no distortion. Positions computed with it have errors of about 10 %.
CameraCalibration guessed_calibration(int width, int height);

/// Reads a camera's calibration file (TOML). Throws InputError with file, line, key and the allowed values.
CameraCalibration load_calibration(const std::filesystem::path& file);
CameraCalibration parse_calibration(const std::string& toml, const std::string& file);
std::string write_calibration(const CameraCalibration& calibration);

}  // namespace prosector
