#pragma once
// `prosector-client camera`: calibrates a camera's lens from views of a board, aligns a camera with a
// tracker, tests a camera, and records its images.

#include <filesystem>
#include <string>

#include "drivers/camera/calibration/tracker_fit.h"

namespace prosector {

struct CameraCommandOptions {
  std::string camera = "0";           // address in the format of open_camera()
  std::string second;                 // address of a second camera to calibrate with the first; empty: none
  std::string board = "calibration";  // calibration target: name of a known board, or a file
  std::filesystem::path out;          // output file
  std::filesystem::path lens;         // existing calibration: used by the self-test and by the alignment
  double seconds = 20;                // duration of the self-test or of the recording, s
  double time_limit = 300;            // timeout of the calibration, s
  std::string tracker;                // tracker with the receiver to which the board is attached: DRIVER:PATH
  std::filesystem::path tracker_config;  // configuration of the tracker; empty: its frame is the room frame
  std::size_t station = 1;               // number of the receiver, from 1
  std::size_t poses = recommended_tracked_pairs;
  std::filesystem::path
      out_config;  // configuration to which the camera poses are written; may be empty for a calibration
};

/// Guides the user through a lens calibration in the terminal and writes its file. Returns the exit code.
/// Throws InputError if the camera can't be opened or the calibration fails.
int calibrate_camera(const CameraCommandOptions& options);
/// Guides the user through a simultaneous calibration of two cameras. Writes both lens files and, if a
/// configuration is named, the relative pose of the cameras into it. Returns and throws like
/// calibrate_camera().
int calibrate_pair(const CameraCommandOptions& options);
/// Guides the user through showing a camera a board on a tracker's receiver, and writes the camera's pose
/// into a configuration. Returns the exit code. Throws InputError if there is no valid result.
int align_camera(const CameraCommandOptions& options);
/// Analyses a camera's images for a while and prints a report. Returns 0 if the camera is good, else 1.
int test_camera(const CameraCommandOptions& options);

}  // namespace prosector
