#pragma once
// What calibration found of one camera, in a file.

#include <filesystem>
#include <string>

#include "drivers/camera/camera.h"

namespace prosector {

struct CameraCalibration {
  std::string camera;  // its identity
  Lens lens;
  double response = usual_response;
  double error = 0;  // pixels RMS, of views that weren't fitted
};

/// Returns a guess for pictures of that size: 60° across, no distortion. Places are then right to a tenth or
/// so.
CameraCalibration guessed_calibration(int width, int height);

/// Reads a file. Throws InputError with file, line, key and what is allowed.
CameraCalibration load_calibration(const std::filesystem::path& file);
CameraCalibration parse_calibration(const std::string& toml, const std::string& file);
std::string write_calibration(const CameraCalibration& calibration);

}  // namespace prosector
