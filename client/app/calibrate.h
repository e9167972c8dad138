#pragma once
// `prosector-client calibrate`: guided procedures in the terminal, with a real device or its twin.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace prosector {

struct CalibrateOptions {
  std::string what;                     // room, tip, field, glove, noise, latency, eyes, phantom
  std::filesystem::path config;         // of the client
  bool write = false;                   // what came out into `config`
  std::string station;                  // role of the receiver; empty: the instrument, else the right hand
  std::vector<std::string> points;      // x,y,z in the room, or of a phantom's shape, m
  std::vector<std::string> targets;     // x,y,z of a phantom's shape, m
  std::array<double, 3> low{}, high{};  // m, room: corners of the grid
  std::array<std::size_t, 3> grid = {5, 5, 5};  // points an axis
  std::vector<double> orientation;           // w, x, y, z of the receiver on the grid, room; empty: unknown
  std::filesystem::path map = "field.toml";  // beside the configuration
  std::string hand = "right";                // of the glove
  double seconds = 10;                       // to watch
  std::string against;                       // a twin's log, or the address of a second device
  double marks = 0, screen = 0, rod = 0;     // m: the sight
  std::vector<std::filesystem::path> seen;   // CSV of pairs: left eye, right eye
  std::array<int, 2> size = {800, 600};      // pixels of each eye
  double patience = 600;                     // s for all of it
};

/// Adds the options of the command.
void add_calibrate(CLI::App& command, CalibrateOptions& options);

/// Calibrates. Returns the exit code; throws InputError for bad input, or where nothing good came out.
int calibrate(const CalibrateOptions& options);

}  // namespace prosector
