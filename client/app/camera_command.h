#pragma once
// prosector-client camera: a camera's lens is found by showing it a board; what its pictures are like is
// said; they are kept.

#include <filesystem>
#include <string>

#include "drivers/camera/calibration/tracker_fit.h"

namespace prosector {

struct CameraCommandOptions {
  std::string camera = "0";              // an address, as open_camera() takes it
  std::string second;                    // another camera, calibrated together with it; empty: none
  std::string board = "calibration";     // that is shown: a known board, or a file
  std::filesystem::path out;             // file to write
  std::filesystem::path lens;            // of the self-test: a calibration that is there
  double seconds = 20;                   // of the self-test, or of a film
  double patience = 300;                 // s for the calibration
  std::string tracker;                   // whose receiver wears the board: DRIVER:PATH
  std::filesystem::path tracker_config;  // that says how the tracker is set up; empty: its frame is the room
  std::size_t station = 1;               // the receiver, from 1
  std::size_t poses = usual_tracked_pairs;
  std::filesystem::path out_config;  // that gets the camera's place, or the cameras'; calibrate: may be empty
};

/// Leads through a calibration in the terminal and writes its file. Returns the exit code. Throws InputError
/// where the camera can't be opened, or no calibration came out.
int calibrate_camera(const CameraCommandOptions& options);
/// Leads through the calibration of two cameras at once. Writes both lenses' files, and how the cameras stand
/// to each other into a configuration, where one is named. Returns and throws as calibrate_camera() does.
int calibrate_pair(const CameraCommandOptions& options);
/// Leads through holding a board on a tracker's receiver before a camera, and writes where the camera stands
/// into a configuration. Returns the exit code. Throws InputError where nothing good came out.
int align_camera(const CameraCommandOptions& options);
/// Looks at a camera's pictures for a while and says what they are like. Returns 0 where all is well, else 1.
int test_camera(const CameraCommandOptions& options);

}  // namespace prosector
