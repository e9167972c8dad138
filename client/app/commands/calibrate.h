#pragma once
// `prosector-client calibrate`: guided calibrations in the terminal, with a real device or its twin.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace prosector {

struct CalibrateOptions {
  std::string what;              // procedure: room, tip, field, glove, noise, latency, eyes, phantom
  std::filesystem::path config;  // client configuration
  bool write = false;            // write the results into `config`
  std::string station;  // role of the receiver; empty: the instrument if there is one, else the right hand
  std::vector<std::string> points;              // x,y,z in the room frame, or in a phantom's frame, m
  std::vector<std::string> targets;             // x,y,z in a phantom's frame, m
  std::array<double, 3> low{}, high{};          // corners of the grid, room frame, m
  std::array<std::size_t, 3> grid = {5, 5, 5};  // number of points along each axis
  std::vector<double>
      orientation;  // w, x, y, z: orientation of the receiver on the grid, room frame; empty: unknown
  std::filesystem::path map = "field.toml";  // relative to the configuration's folder
  std::string hand = "right";                // which hand's glove
  double seconds = 10;                       // duration of the measurement, s
  std::string against;                       // a twin's log file, or the address of a second device
  double marks = 0, screen = 0,
         rod = 0;  // m: distance between the marks, from the eyes to the screen, from the eyes to the rod
  std::vector<std::filesystem::path> seen;  // CSV files of point pairs: left eye, right eye
  std::array<int, 2> size = {800, 600};     // image width and height of each eye, pixels
  double time_limit = 600;                  // timeout of the whole procedure, s
};

/// Adds the command-line options of `prosector-client calibrate` to `command`. Parsing stores their values in
/// `options`, which must outlive it.
void add_calibrate(CLI::App& command, CalibrateOptions& options);

/// Runs the guided calibration that `options.what` names in the terminal. Returns the program's exit code.
/// Throws InputError for bad input, or if the calibration gives no valid result.
int calibrate(const CalibrateOptions& options);

}  // namespace prosector
