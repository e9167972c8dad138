#include "client/app/run/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "client/app/commands/calibrate.h"
#include "client/app/commands/config_command.h"
#include "client/app/commands/record_device.h"
#include "client/app/run/option_groups.h"
#include "client/app/run/option_values.h"
#include "client/render/shader_dir.h"
#include "common/error.h"
#include "common/version.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

RenderOptions resolve_render(const RawOptions& raw, RenderOptions o) {
  if (!raw.size.empty()) parse_size(raw.size, o.width, o.height);
  o.quality = parse_quality(raw);
  if (o.shaders.empty()) o.shaders = default_shader_dir();
  return o;
}

/// Sets the interface and the DDS profile from the options.
void resolve_network(const RawOptions& raw, BusConfig& bus) {
  bus.interface = raw.lan.value_or("");
  if (bus.profile.empty() && raw.lan) bus.profile = "lan";
  if (bus.profile.empty() && !bus.peers.empty()) bus.profile = "wan";
}

SetupOptions resolve_setup(const RawOptions& raw, ClientOptions& o, SetupOptions setup) {
  if (!raw.size.empty()) parse_size(raw.size, setup.width, setup.height);
  resolve_network(raw, o.bus);
  setup.bus = o.bus;
  setup.name = raw.user_name.empty() ? login_name() : raw.user_name;
  setup.words = catalogue_for(parse_language(raw.language));
  if (!raw.language.empty()) setup.language = parse_language(raw.language);
  if (setup.shaders.empty()) setup.shaders = default_shader_dir();
  return setup;
}

/// Replaces the profile's values by calibrated ones.
void take_eyes(const EyeSettings& eyes, StereoProfile& profile) {
  profile.eye_distance = eyes.distance.value_or(profile.eye_distance);
  profile.fov_horizontal = eyes.fov_horizontal.value_or(profile.fov_horizontal);
  profile.fov_vertical = eyes.fov_vertical.value_or(profile.fov_vertical);
  profile.convergence = eyes.convergence.value_or(profile.convergence);
}

/// Throws InputError if a window into the room is requested with a display that can't be one.
void check_window(const ClientOptions& o) {
  const bool fits = o.display.kind == Display::window || o.display.kind == Display::offscreen ||
                    o.display.kind == Display::osmesa;
  if (!o.devices.window.address.empty() && (!fits || !o.ar.camera.empty()))
    throw InputError(
        "--window (or [window] of the configuration) works only with --display window, offscreen or osmesa, "
        "not with ar");
}

/// Returns the named camera, or the tracker's. Throws InputError if there is none. `wants`: the option that
/// needs it.
std::string resolve_camera(const RawOptions& raw, const ClientOptions& o, const char* wants) {
  const std::string camera = raw.camera.empty() ? first_camera(o.devices.tracker) : raw.camera;
  if (camera.empty())
    throw InputError(
        fmt::format("{} needs a camera: choose a camera with --camera, e.g. --camera /dev/video0", wants));
  return camera;
}

void resolve(const RawOptions& raw, ClientOptions& o) {
  const bool through_camera = parse_display(raw.display, o.display);
  if (o.display.monitor && o.display.kind != Display::window && o.display.kind != Display::stereo)
    throw InputError("--monitor is allowed only with --display window or stereo");
  if (o.display.audience && o.display.kind != Display::window && o.display.kind != Display::stereo &&
      o.display.kind != Display::openxr)
    throw InputError("--spectator-window is allowed only with --display window, stereo or openxr");
  if (!raw.size.empty()) parse_size(raw.size, o.display.width, o.display.height);
  o.rendering.quality = parse_quality(raw);
  o.view.shown = parse_shown(raw.show);
  for (const std::string& text : raw.screenshots) o.output.screenshots.push_back(parse_screenshot(text));
  for (const std::string& text : raw.offers) o.offers.poses.push_back(parse_offer(text));
  o.source = {raw.config, raw.tracker, raw.glove_left, raw.glove, raw.arm};
  o.devices = o.source.read();
  if (!raw.window.empty()) o.devices.window.address = raw.window;
  if (!o.devices.window.address.empty()) (void)parse_device_address(o.devices.window.address);
  if (through_camera) {
    o.ar.camera = resolve_camera(raw, o, "--display ar");
    if (!o.view.follow.empty() || !o.view.insets.empty())
      throw InputError("--display ar: cannot be combined with --follow or --inset");
  }
  if (raw.offers_camera) o.offers.camera = resolve_camera(raw, o, "--publish-camera");
  if (!through_camera && !raw.offers_camera && !raw.camera.empty())
    throw InputError("--camera is allowed only with --display ar or --publish-camera");
  check_window(o);
  if (!through_camera && !raw.phantoms.empty())
    throw InputError("--phantom is allowed only with --display ar");
  if (!through_camera && !o.logs.pictures.empty())
    throw InputError("--frame-log is allowed only with --display ar");
  o.ar.phantoms = raw.phantoms;
  const PhantomSettings& phantom = o.devices.phantom;
  if (through_camera && !phantom.mesh.empty() && !phantom.has_place())
    throw InputError(
        "phantom.mesh: the shape's pose is missing: set phantom.board in the configuration, or run "
        "`prosector-client calibrate phantom`");
  if (!phantom.body.empty() && !phantom.has_place()) o.ar.phantoms.push_back(phantom.body);
  take_eyes(o.devices.eyes, o.display.stereo);
  o.join.language = parse_language(raw.language);
  o.words = catalogue_for(o.join.language);
  o.join.name = raw.user_name.empty() ? login_name() : raw.user_name;
  resolve_network(raw, o.bus);
  o.bus.end = o.join.role == Role::observer ? BusEnd::observer : BusEnd::dissector;
  o.bus.arm = o.bus.end == BusEnd::dissector && !o.devices.arm.address.empty();
  if (o.rendering.shaders.empty()) o.rendering.shaders = default_shader_dir();
  if (o.rendering.watch_shaders && o.rendering.shaders.empty())
    throw InputError("--watch-shaders: give the folder to watch with --shaders");
}

/// Options of the commands that join no session.
struct DeviceCommands {
  CalibrateOptions calibrate;
  RecordOptions record;
  ConfigOptions config;
  SelfTestOptions test;
  CameraCommandOptions camera;
};

/// Adds a command. Parsing the command line stores a function in `task` that runs it with its options.
template <class Options>
void add_command(CLI::App& app, const char* name, const char* help, Options& options,
                 void (*add)(CLI::App&, Options&), int (*run)(const Options&), Task& task) {
  CLI::App* command = app.add_subcommand(name, help);
  add(*command, options);
  command->callback([&options, &task, run] { task = [options, run] { return run(options); }; });
}

void add_device_commands(CLI::App& app, DeviceCommands& o, Task& task) {
  add_command(app, "calibrate", "Guided calibration: tracker, instrument, glove, eyes", o.calibrate,
              add_calibrate, calibrate, task);
  add_command(app, "record", "Record a device's samples to a file, without a server", o.record, add_record,
              record_device, task);
  add_command(app, "config", "Check or change a configuration", o.config, add_config, run_config, task);
  add_command(app, "selftest", "Record a device and check that it follows its protocol", o.test,
              add_self_test, self_test, task);
  add_camera(*app.add_subcommand("camera", "Calibrate a camera, or report its image quality"), o.camera,
             task);
}

}  // namespace

std::string used_camera(const ClientOptions& options) {
  return options.ar.camera.empty() ? first_camera(options.devices.window.address) : options.ar.camera;
}

ClientCommand parse_command_line(int argc, char** argv) {
  ClientOptions o;
  RawOptions raw;
  CLI::App app{
      "Joins or observes a session hosted by prosector-server.\n  prosector-client                           "
      "                a window to find, host and join sessions\n  prosector-client join --name NAME         "
      "                 mouse and keyboard control your hand\n  prosector-client join --name NAME --tracker "
      "fastrak:/dev/ttyS0 --glove 5dt:/dev/ttyS1 --display stereo\n  prosector-client observe --follow NAME "
      "--record session.avi\n  prosector-client render SCENE --out DIR                    renders a scene "
      "file without a server",
      "prosector-client"};
  app.set_version_flag("--version", version_line("prosector-client"));
  app.require_subcommand(0, 1);
  SetupOptions setup;
  CLI::App* set_up = app.add_subcommand("setup", "Open the set-up window (default without a command)");
  add_setup(*set_up, setup, o, raw);
  CLI::App* join = app.add_subcommand("join", "Join a session to touch, grasp and move bodies");
  CLI::App* observe =
      app.add_subcommand("observe", "Observe a session without affecting it; possible at any time");
  for (CLI::App* command : {join, observe}) {
    add_run(*command, o, raw);
    add_network(*command, o, raw);
    add_offers(*command, raw);
    add_pictures(*command, o, raw);
  }
  add_devices(*join, raw);
  CLI::App* render = app.add_subcommand("render", "Render a scene file, without a server");
  RenderOptions still;
  add_render(*render, still, raw);
  DeviceCommands device_commands;
  Task task;
  add_device_commands(app, device_commands, task);
  bool host = false;
  join->add_flag("--host", host,
                 "Become the session's host, which assigns roles, if the session has no host");
  try {
    app.parse(argc, argv);
    if (task) return task;
    if (render->parsed()) return resolve_render(raw, still);
    if (app.get_subcommands().empty() || set_up->parsed()) return resolve_setup(raw, o, setup);
    o.join.role = !join->parsed() ? Role::observer : host ? Role::host : Role::dissector;
    resolve(raw, o);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return o;
}

}  // namespace prosector
