#pragma once
// `prosector-client camera`: calibrates a camera's lens from views of a board, aligns a camera with a
// tracker, tests a camera, and records its images.

#include <filesystem>
#include <functional>
#include <string>

#include "drivers/camera/calibration/tracker_fit.h"

namespace CLI {
class App;
}

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

/// Guides the user through the calibration of a camera's lens in the terminal, and writes the result to
/// `options.out`. Returns the program's exit code. Throws InputError if the camera can't be opened or the
/// calibration fails.
int calibrate_camera(const CameraCommandOptions& options);
/// Guides the user through a simultaneous calibration of two cameras in the terminal. Writes both lens files
/// and, if `options.out_config` is named, the cameras' relative pose into that configuration. Returns the
/// program's exit code. Throws InputError if a camera can't be opened or the calibration fails.
int calibrate_pair(const CameraCommandOptions& options);
/// Determines a camera's pose in the tracker's frame: guides the user through showing it a board that is
/// fixed to a tracker's receiver. Writes the pose into the configuration `options.out_config`. Returns the
/// program's exit code. Throws InputError if there is no valid result.
int align_camera(const CameraCommandOptions& options);
/// Analyses a camera's images for `options.seconds` and prints a report on their quality. Returns 0 if the
/// camera is good, else 1.
int test_camera(const CameraCommandOptions& options);

/// Adds the subcommands of `prosector-client camera` (calibrate, selftest, align, record) with their options.
/// Parsing the command line stores the values in `o`, and stores a function in `task` that runs the given
/// subcommand.
void add_camera(CLI::App& camera, CameraCommandOptions& o, std::function<int()>& task);

}  // namespace prosector
