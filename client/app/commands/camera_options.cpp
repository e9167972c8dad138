#include <CLI/CLI.hpp>

#include "client/app/commands/camera_command.h"
#include "client/app/commands/record_camera.h"
#include "common/former_option_name.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

void add_calibration(CLI::App& command, CameraCommandOptions& o) {
  command.add_option("--out", o.out, "File to write")->required();
  CLI::Option* second = command.add_option(
      "--second", o.second,
      "Second camera; calibrates both lenses and the second camera's pose relative to the first one");
  command
      .add_option("--out-config", o.out_config,
                  "Client configuration file to which both lenses and the second camera's pose "
                  "(tracker.second) are written")
      ->check(CLI::ExistingFile)
      ->needs(second);
}

void add_alignment(CLI::App& command, CameraCommandOptions& o) {
  command
      .add_option("--tracker", o.tracker,
                  "Tracker whose receiver is fixed to the calibration board, DRIVER:PATH")
      ->required();
  command
      .add_option("--tracker-config", o.tracker_config, "Client configuration file with the tracker's pose")
      ->check(CLI::ExistingFile);
  command
      .add_option("--station", o.station, "Number of the receiver that the board is fixed to, counted from 1")
      ->check(CLI::Range(std::size_t{1}, max_stations))
      ->capture_default_str();
  command.add_option("--poses", o.poses, "Number of board poses")
      ->check(CLI::Range(min_tracked_pairs, std::size_t{200}))
      ->capture_default_str();
  command
      .add_option("--out-config", o.out_config,
                  "Client configuration file to which the camera's pose (tracker.room) is written")
      ->check(CLI::ExistingFile)
      ->required();
}

void add_board(CLI::App& command, CameraCommandOptions& o) {
  command
      .add_option("--board", o.board,
                  "Board to show to the camera: name of a known board (prosector-board --list), or a "
                  "board file (.toml)")
      ->capture_default_str();
  CLI::Option* timeout = command.add_option("--timeout", o.time_limit, "Time limit of the calibration, s");
  timeout->capture_default_str();
  accept_former_name(command, *timeout, "--patience");
}

}  // namespace

void add_camera(CLI::App& camera, CameraCommandOptions& o, std::function<int()>& task) {
  camera.require_subcommand(1);
  const auto add = [&](const char* name, const char* help, int (*run)(const CameraCommandOptions&)) {
    CLI::App* command = camera.add_subcommand(name, help);
    command
        ->add_option("CAMERA", o.camera,
                     "Camera: device number or path, video file, stream URL, or synthetic:SCENE.toml")
        ->capture_default_str();
    command->callback([&o, &task, run] { task = [options = o, run] { return run(options); }; });
    return command;
  };
  CLI::App* calibrate =
      add("calibrate", "Calibrate the lens: show a board to the camera as instructed", calibrate_camera);
  CLI::App* test =
      add("selftest", "Measure a camera's image quality: image rate, brightness, noise, detection of boards",
          test_camera);
  CLI::App* align =
      add("align",
          "Determine the camera's pose in the room with a board that is fixed to a receiver of a tracker",
          align_camera);
  CLI::App* record =
      add("record", "Record the camera's images as a video, which can be used in place of a camera",
          record_camera);
  for (CLI::App* command : {calibrate, align}) add_board(*command, o);
  add_calibration(*calibrate, o);
  test->add_option("--out", o.out, "File for the report");
  for (CLI::App* command : {test, align})
    command->add_option("--lens", o.lens, "The camera's calibration")->check(CLI::ExistingFile);
  add_alignment(*align, o);
  record->add_option("--out", o.out, "Video to write, .avi")->required();
  for (CLI::App* command : {test, record})
    command->add_option("--seconds", o.seconds, "Duration of the measurement")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
}

}  // namespace prosector
