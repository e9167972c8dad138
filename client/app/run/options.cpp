#include "client/app/run/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>

#include "client/app/commands/calibrate.h"
#include "client/app/commands/config_command.h"
#include "client/app/commands/record_camera.h"
#include "client/app/commands/record_device.h"
#include "client/render/shader_dir.h"
#include "common/error.h"
#include "common/local_name.h"
#include "common/version.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

constexpr const char* shaders_help =
    "Folder of shaders to use (default: $PROSECTOR_SHADERS, else the built-in ones)";

const std::map<std::string, Display> displays = {
    {"window", Display::window},       {"stereo", Display::stereo}, {"openxr", Display::openxr},
    {"offscreen", Display::offscreen}, {"osmesa", Display::osmesa}, {"none", Display::none}};

struct RawOptions {
  std::string tracker, glove, glove_left, arm, config, size, camera, window, user_name, language,
      display = "window", quality = "medium", show = "none";
  std::optional<std::string> lan;  // interface name; empty: the only network interface
  std::vector<std::string> screenshots, effects, offers, phantoms;
  bool offers_camera = false;
  std::optional<double> detail;
};

std::string effect_names(std::string_view between) {
  std::string out;
  for (const EffectRow& row : effect_rows) out += fmt::format("{}{}", out.empty() ? "" : between, row.name);
  return out;
}

void add_network(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option("--session", o.bus.session, "Name of the session to join")
      ->capture_default_str()
      ->group("Network");
  app.add_option("--domain", o.bus.domain, "DDS domain")
      ->capture_default_str()
      ->check(CLI::Range(0, 230))
      ->group("Network");
  app.add_option("--peer", o.bus.peers, "Machine of a server, HOST or HOST:PORT (repeatable)")
      ->group("Network");
  app.add_option_function<std::vector<std::string>>(
         "--lan",
         [&raw](const std::vector<std::string>& names) { raw.lan = names.empty() ? "" : names.front(); },
         "Search the local network, on this interface if there are several, e.g. eth0")
      ->expected(0, 1)
      ->type_name("[IFACE]")
      ->group("Network");
  app.add_option("--profile", o.bus.profile,
                 "Network profile: loopback, lan, wan or a DDS profile file (docs/do/network.md)")
      ->group("Network");
  app.add_option_function<double>(
         "--patience",
         [&o](double s) { o.join.time_limit = std::chrono::milliseconds(static_cast<int>(1e3 * s)); },
         "Seconds to look for the session (default 5)")
      ->check(CLI::Range(0.1, 600.0))
      ->group("Network");
}

CLI::Option* add_detail_option(CLI::App& app, RawOptions& raw) {
  return app
      .add_option("--detail", raw.detail,
                  "Level-of-detail error in pixels; 0 = full detail (default: from the quality)")
      ->check(CLI::Range(0.0, 100.0));
}

void add_offers(CLI::App& app, RawOptions& raw) {
  app.add_option("--offer", raw.offers,
                 "Publish hands, heads and held tools to other software (repeatable): vrpn or igtl for this "
                 "machine only, or vrpn:ADDRESS:PORT")
      ->group("Network");
  app.add_flag("--offer-camera", raw.offers_camera,
               "Also publish the images of --camera, or of the tracker's camera, by igtl as IMAGE")
      ->needs("--offer")
      ->group("Network");
}

void add_pictures(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option("--display", raw.display,
                 "Display: window; stereo or stereo:PROFILE (side by side; a name in deploy/stereo, or a "
                 "file); openxr (headset with head and hand tracking); ar or ar:offscreen (the scene over a "
                 "camera image); offscreen; osmesa; none")
      ->capture_default_str()
      ->group("Pictures");
  app.add_option("--camera", raw.camera,
                 "Camera for --display ar or --offer-camera: /dev/video0, a number, a video file, a stream, "
                 "synthetic:SCENE.toml, or igtl://HOST/DEVICE (default: the tracker's camera)")
      ->group("Pictures");
  app.add_option("--window", raw.window,
                 "Use the screen as a window into the room for the eyes tracked by this device: face:CAMERA, "
                 "as with --tracker (docs/do/window.md)")
      ->group("Pictures");
  app.add_option("--phantom", raw.phantoms,
                 "With --display ar: name of a body with a real counterpart (phantom). It is not drawn, and "
                 "occludes what is behind it (repeatable)")
      ->group("Pictures");
  app.add_option("--quality", raw.quality, "Rendering quality: low, medium, high")
      ->capture_default_str()
      ->group("Pictures");
  app.add_option_function<double>(
         "--frame-time", [&o](double ms) { o.frame_time = 1e-3 * ms; },
         "Target frame time, ms: adjusts the quality automatically; --quality, --effect and --detail are "
         "ignored")
      ->check(CLI::Range(1.0, 1000.0))
      ->group("Pictures");
  app.add_option("--effect", raw.effects,
                 "Turn a rendering effect on or off, NAME=on or NAME=off (repeatable): " + effect_names(", "))
      ->group("Pictures");
  add_detail_option(app, raw)->group("Pictures");
  app.add_option("--size", raw.size, "Frame size, WIDTHxHEIGHT (default 800x600; stereo: from the profile)")
      ->group("Pictures");
  app.add_option("--monitor", o.monitor, "Full screen on this monitor, from 0 (F11: back to a window)")
      ->check(CLI::NonNegativeNumber)
      ->group("Pictures");
  // As text: CLI11 would convert a missing number to 0.
  app.add_option_function<std::string>(
         "--audience",
         [&o](const std::string& monitor) {
           o.audience.emplace();
           if (!monitor.empty()) o.audience->monitor = std::stoi(monitor);
         },
         "Open a second window for spectators with the same view (stereo: one eye), or full screen on this "
         "monitor")
      ->expected(0, 1)
      ->type_name("[MONITOR]")
      ->check(CLI::Range(0, 99))
      ->group("Pictures");
  app.add_option("--scale", o.scale,
                 "Scale of texts and overlays (default: the desktop's, or suited to the headset)")
      ->check(CLI::Range(0.5, 8.0))
      ->group("Pictures");
  app.add_option("--fps", o.frames_per_second, "Maximum frames per second")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 240.0))
      ->group("Pictures");
  app.add_option("--follow", o.follow, "Show the view of the participant with this name")->group("Pictures");
  app.add_option("--inset", o.insets,
                 "Show the view of the participant with this name as an inset (repeatable)")
      ->group("Pictures");
  app.add_option(
         "--screenshot", raw.screenshots,
         "Write a screenshot (PNG) at the end, or with FILE@SECONDS at that time after joining (repeatable)")
      ->group("Pictures");
  app.add_option("--record", o.record, "Record a video, .avi or .mp4 (headset: left eye)")->group("Pictures");
  const auto sheet =
      app.add_option("--sheet", o.sheet, "Contact sheet of the session (PNG), written at the end")
          ->group("Pictures");
  app.add_option("--every", o.sheet_interval, "Seconds between two frames of the contact sheet")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0))
      ->needs(sheet)
      ->group("Pictures");
  app.add_option("--shaders", o.shaders, shaders_help)->group("Pictures");
  app.add_flag("--watch-shaders", o.watch_shaders, "Reload the shaders when a file in their folder changes")
      ->group("Pictures");
  app.add_flag("!--no-overlay", o.overlay, "Hide figures and axes")->group("Pictures");
  app.add_flag("--wireframes", o.wireframes, "Draw collision shapes as white wireframes")->group("Pictures");
  app.add_option("--show", raw.show, "Colour soft bodies by strain, residual, error or none")
      ->capture_default_str()
      ->group("Pictures");
}

void add_run(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option("--name", raw.user_name, "Your name, as others see it (default: your login name)");
  app.add_option("--language", raw.language,
                 "Language tag for messages, help and part names, e.g. de, tr (default: from the locale)");
  app.add_option("--seconds", o.seconds, "Leave after this time (default: stay)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--summary", o.summary, "Write a summary of this run as JSON")->group("Measurement");
  app.add_option("--session-log", o.session_log,
                 "Write session events as JSON lines: grasps, parts, panels, hand forces")
      ->group("Measurement");
  app.add_option("--latency-log", o.latency_log,
                 "Write the times of sent inputs or received snapshots as CSV")
      ->group("Measurement");
  app.add_option("--picture-log", o.picture_log,
                 "With --display ar: write the time and content of each frame as CSV")
      ->group("Measurement");
}

void add_devices(CLI::App& app, RawOptions& raw) {
  app.add_option("--tracker", raw.tracker, "Tracker, DRIVER:PATH, e.g. fastrak:/dev/ttyS0")->group("Devices");
  app.add_option("--glove", raw.glove, "Right glove, e.g. 5dt:/dev/ttyS1 or 5dt-usb:/dev/hidraw0")
      ->group("Devices");
  app.add_option("--glove-left", raw.glove_left, "Left glove")->group("Devices");
  app.add_option("--arm", raw.arm, "Haptic arm of the right hand, e.g. omni-twin:/tmp/omni")
      ->group("Devices");
  app.add_option("--config", raw.config, "Client configuration, see deploy/client.toml")
      ->check(CLI::ExistingFile)
      ->group("Devices");
}

void add_render(CLI::App& app, RenderOptions& o, RawOptions& raw) {
  app.add_option("SCENE", o.scene, "Scene file, e.g. deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  app.add_option("--out", o.out, "Output folder; created if missing")->required();
  app.add_option("--view", o.view, "Render only this view, e.g. close (default: all)");
  app.add_flag("--compare", o.compare, "Also render with each effect switched, where it makes a difference");
  app.add_flag("--sheet", o.sheet, "Also write a contact sheet of all frames");
  app.add_option("--turntable", o.turntable, "Also write a turntable video of this many seconds")
      ->check(CLI::Range(0.1, 600.0));
  app.add_flag("--osmesa", o.osmesa, "Use OSMesa even if EGL is available");
  app.add_option("--quality", raw.quality, "low, medium, high")->capture_default_str();
  app.add_option(
      "--effect", raw.effects,
      "Turn a rendering effect on or off, NAME=on or NAME=off (repeatable): " + effect_names(", "));
  add_detail_option(app, raw);
  app.add_option("--size", raw.size, "Frame size, WIDTHxHEIGHT (default 640x480)");
  app.add_option("--shaders", o.shaders, shaders_help);
}

void add_setup(CLI::App& app, SetupOptions& setup, ClientOptions& o, RawOptions& raw) {
  add_network(app, o, raw);
  app.add_option("--name", raw.user_name, "Initial user name (default: your login name)");
  app.add_option("--language", raw.language,
                 "Language tag for the window and sessions, e.g. de, tr (default: from the locale)");
  app.add_option("--scenes", setup.scenes, "Folder of scenes to host (default: the installed scenes)")
      ->check(CLI::ExistingDirectory);
  app.add_option("--config", setup.config, "Client configuration; created when saved");
  app.add_option("--size", raw.size, "Window size, WIDTHxHEIGHT (default 1280x720)");
  app.add_option("--scale", setup.scale, "Scale of texts and controls (default: the desktop's)")
      ->check(CLI::Range(0.5, 8.0));
  app.add_option("--layout-log", setup.layout_log,
                 "Write the positions of controls as JSON whenever they change, for scripts");
  app.add_option("--shaders", setup.shaders, shaders_help);
}

void add_self_test(CLI::App& app, SelfTestOptions& o) {
  app.add_option("ADDRESS", o.address,
                 "Device, DRIVER:PATH, e.g. 5dt-usb:/dev/hidraw0; with --config also tracker, glove.right, "
                 "glove.left (default: the first one configured)");
  app.add_option("--config", o.config, "Client configuration: address, receivers, pose, counts")
      ->check(CLI::ExistingFile);
  app.add_option("--seconds", o.seconds, "Duration of the recording")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--out", o.out, "Report file; samples are written to a .csv file beside it")
      ->capture_default_str();
}

void parse_size(const std::string& text, int& width, int& height) {
  const auto x = text.find('x');
  const auto number = [&](std::size_t from, std::size_t to, int& out) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, out);
    return error == std::errc() && end == text.data() + to && out >= 16 && out <= 8192;
  };
  if (x == std::string::npos || !number(0, x, width) || !number(x + 1, text.size(), height))
    throw InputError("--size " + text + ": must be WIDTHxHEIGHT, each 16 to 8192, e.g. 800x600");
}

/// Parses DISPLAY, stereo:PROFILE or ar:DISPLAY; a profile sets the frame size. Returns whether the display
/// is an augmented camera image.
bool parse_display(const std::string& text, ClientOptions& o) {
  const auto colon = text.find(':');
  if (text == "ar" || text == "ar:offscreen") {
    o.display = text == "ar" ? Display::window : Display::offscreen;
    return true;
  }
  const auto found = displays.find(text.substr(0, colon));
  if (found == displays.end() || (colon != std::string::npos && found->second != Display::stereo))
    throw InputError(
        "--display " + text +
        ": must be window, stereo, stereo:PROFILE, openxr, ar, ar:offscreen, offscreen, osmesa or none");
  o.display = found->second;
  if (o.display != Display::stereo) return false;
  if (colon != std::string::npos) o.stereo = load_stereo_profile(text.substr(colon + 1));
  o.width = o.stereo.picture_width();
  o.height = o.stereo.picture_height();
  return false;
}

void parse_effect(const std::string& text, EffectSet& effects) {
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const std::string state = equals == std::string::npos ? "" : text.substr(equals + 1);
  const auto row = std::find_if(effect_rows.begin(), effect_rows.end(),
                                [&](const EffectRow& known) { return known.name == name; });
  if (row == effect_rows.end() || (state != "on" && state != "off"))
    throw InputError(
        fmt::format("--effect {}: must be NAME=on or NAME=off, with NAME {}", text, effect_names(", ")));
  effects[static_cast<std::size_t>(row - effect_rows.begin())] = state == "on";
}

QualityLevel parse_quality(const RawOptions& raw) {
  for (const QualityLevel& level : quality_levels)
    if (level.name == raw.quality) {
      QualityLevel out = level;
      for (const std::string& effect : raw.effects) parse_effect(effect, out.settings.effects);
      out.detail = raw.detail.value_or(out.detail);
      return out;
    }
  throw InputError("--quality " + raw.quality + ": must be low, medium or high");
}

Shown parse_shown(const std::string& text) {
  for (std::size_t k = 0; k < value_scales.size(); ++k)
    if (value_scales[k].name == text) return static_cast<Shown>(k);
  throw InputError("--show " + text + ": must be strain, residual, error or none");
}

Screenshot parse_screenshot(const std::string& text) {
  const auto at = text.rfind('@');
  if (at == std::string::npos) return {text, std::nullopt};
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data() + at + 1, text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || !(seconds >= 0))
    throw InputError("--screenshot " + text + ": @ must be followed by a number of seconds");
  return {text.substr(0, at), seconds};
}

std::string login_name() {
  const char* user = std::getenv("USER");
  return user != nullptr && *user != '\0' ? user : "guest";
}

/// Returns the language of messages from the environment variables, in the order that POSIX defines.
std::string locale_language() {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* value = std::getenv(variable); value != nullptr && *value != '\0')
      return language_of_locale(value);
  return "";
}

std::string parse_language(const std::string& text) {
  if (text.empty()) return locale_language();
  std::string tag = text;
  std::ranges::replace(tag, '_', '-');
  if (!is_language_tag(tag))
    throw InputError("--language " + text + ": must be a language tag, e.g. de, tr, pt-BR");
  return tag;
}

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
  const bool fits =
      o.display == Display::window || o.display == Display::offscreen || o.display == Display::osmesa;
  if (!o.devices.window.address.empty() && (!fits || !o.camera.empty()))
    throw InputError(
        "--window, or [window] of the configuration: only with --display window, offscreen or "
        "osmesa");
}

/// Returns the named camera, or the tracker's. Throws InputError if there is none. `wants`: the option that
/// needs it.
std::string resolve_camera(const RawOptions& raw, const ClientOptions& o, const char* wants) {
  const std::string camera = raw.camera.empty() ? first_camera(o.devices.tracker) : raw.camera;
  if (camera.empty())
    throw InputError(fmt::format("{}: choose a camera with --camera, e.g. /dev/video0", wants));
  return camera;
}

/// Adds the camera subcommands. Returns them: calibrate, selftest, align, record.
std::array<CLI::App*, 4> add_camera(CLI::App& camera, CameraCommandOptions& o) {
  camera.require_subcommand(1);
  CLI::App* calibrate =
      camera.add_subcommand("calibrate", "Calibrate the lens: show a board to the camera as instructed");
  CLI::App* test = camera.add_subcommand("selftest", "Report image quality: rate, brightness, noise, boards");
  CLI::App* align =
      camera.add_subcommand("align", "Determine the camera's pose with a board on a tracker's receiver");
  CLI::App* record =
      camera.add_subcommand("record", "Record its images as a video, which can be used as a camera");
  for (CLI::App* command : {calibrate, test, align, record})
    command
        ->add_option("CAMERA", o.camera,
                     "Device number or path, video file, stream URL, or synthetic:SCENE.toml")
        ->capture_default_str();
  for (CLI::App* command : {calibrate, align}) {
    command->add_option("--board", o.board, "Board to show: a known one, or a file")->capture_default_str();
    command->add_option("--patience", o.time_limit, "Give up after this many seconds")->capture_default_str();
  }
  calibrate->add_option("--out", o.out, "File to write")->required();
  CLI::Option* second = calibrate->add_option(
      "--second", o.second, "Second camera: calibrates both lenses and the cameras' relative pose");
  calibrate
      ->add_option("--out-config", o.out_config, "Configuration to write both lenses and tracker.second to")
      ->check(CLI::ExistingFile)
      ->needs(second);
  test->add_option("--out", o.out, "File for the report");
  for (CLI::App* command : {test, align})
    command->add_option("--lens", o.lens, "The camera's calibration")->check(CLI::ExistingFile);
  align->add_option("--tracker", o.tracker, "DRIVER:PATH of the tracker")->required();
  align->add_option("--tracker-config", o.tracker_config, "Configuration with the tracker's pose")
      ->check(CLI::ExistingFile);
  align->add_option("--station", o.station, "Receiver that the board is fixed to")
      ->check(CLI::Range(std::size_t{1}, max_stations))
      ->capture_default_str();
  align->add_option("--poses", o.poses, "Number of board poses")
      ->check(CLI::Range(min_tracked_pairs, std::size_t{200}))
      ->capture_default_str();
  align
      ->add_option("--out-config", o.out_config, "Configuration to write the camera's pose, tracker.room, to")
      ->check(CLI::ExistingFile)
      ->required();
  record->add_option("--out", o.out, "Video to write, .avi")->required();
  for (CLI::App* command : {test, record})
    command->add_option("--seconds", o.seconds, "Duration of the measurement")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
  return {calibrate, test, align, record};
}

void resolve(const RawOptions& raw, ClientOptions& o) {
  const bool through_camera = parse_display(raw.display, o);
  if (o.monitor && o.display != Display::window && o.display != Display::stereo)
    throw InputError("--monitor: only with --display window or stereo");
  if (o.audience && o.display != Display::window && o.display != Display::stereo &&
      o.display != Display::openxr)
    throw InputError("--audience: only with --display window, stereo or openxr");
  if (!raw.size.empty()) parse_size(raw.size, o.width, o.height);
  o.quality = parse_quality(raw);
  o.shown = parse_shown(raw.show);
  for (const std::string& text : raw.screenshots) o.screenshots.push_back(parse_screenshot(text));
  for (const std::string& text : raw.offers) o.offers.push_back(parse_offer(text));
  o.source = {raw.config, raw.tracker, raw.glove_left, raw.glove, raw.arm};
  o.devices = o.source.read();
  if (!raw.window.empty()) o.devices.window.address = raw.window;
  if (!o.devices.window.address.empty()) (void)parse_device_address(o.devices.window.address);
  if (through_camera) {
    o.camera = resolve_camera(raw, o, "--display ar");
    if (!o.follow.empty() || !o.insets.empty())
      throw InputError("--display ar: cannot be combined with --follow or --inset");
  }
  if (raw.offers_camera) o.offered_camera = resolve_camera(raw, o, "--offer-camera");
  if (!through_camera && !raw.offers_camera && !raw.camera.empty())
    throw InputError("--camera: only with --display ar or --offer-camera");
  check_window(o);
  if (!through_camera && !raw.phantoms.empty()) throw InputError("--phantom: only with --display ar");
  if (!through_camera && !o.picture_log.empty()) throw InputError("--picture-log: only with --display ar");
  o.phantoms = raw.phantoms;
  const PhantomSettings& phantom = o.devices.phantom;
  if (through_camera && !phantom.mesh.empty() && !phantom.has_place())
    throw InputError("phantom.mesh: its pose is missing: set phantom.board, or run `calibrate phantom`");
  if (!phantom.body.empty() && !phantom.has_place()) o.phantoms.push_back(phantom.body);
  take_eyes(o.devices.eyes, o.stereo);
  o.join.language = parse_language(raw.language);
  o.words = catalogue_for(o.join.language);
  o.join.name = raw.user_name.empty() ? login_name() : raw.user_name;
  resolve_network(raw, o.bus);
  o.bus.end = o.join.role == Role::observer ? BusEnd::observer : BusEnd::dissector;
  o.bus.arm = o.bus.end == BusEnd::dissector && !o.devices.arm.address.empty();
  if (o.shaders.empty()) o.shaders = default_shader_dir();
  if (o.watch_shaders && o.shaders.empty())
    throw InputError("--watch-shaders: give the folder to watch with --shaders");
}

}  // namespace

std::string used_camera(const ClientOptions& options) {
  return options.camera.empty() ? first_camera(options.devices.window.address) : options.camera;
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
  CLI::App* join = app.add_subcommand("join", "Participate: touch, grasp and move");
  CLI::App* observe =
      app.add_subcommand("observe", "Observe without affecting the session; possible at any time");
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
  CalibrateOptions calibrating;
  CLI::App* calibrating_app =
      app.add_subcommand("calibrate", "Guided calibration: tracker, instrument, glove, eyes");
  add_calibrate(*calibrating_app, calibrating);
  RecordOptions recording;
  CLI::App* recording_app =
      app.add_subcommand("record", "Record a device's samples to a file, without a server");
  add_record(*recording_app, recording);
  ConfigOptions configuring;
  CLI::App* configuring_app = app.add_subcommand("config", "Check or change a configuration");
  add_config(*configuring_app, configuring);
  CLI::App* test = app.add_subcommand("selftest", "Record a device and check that it follows its protocol");
  SelfTestOptions tried;
  add_self_test(*test, tried);
  CameraCommandOptions seeing;
  CLI::App* camera = app.add_subcommand("camera", "Calibrate a camera, or report its image quality");
  const auto [calibrating_camera, testing_camera, aligning_camera, filming_camera] =
      add_camera(*camera, seeing);
  bool host = false;
  join->add_flag("--host", host, "Become the session's host, who assigns roles, if it has none");
  try {
    app.parse(argc, argv);
    if (calibrating_app->parsed()) return Task([calibrating] { return calibrate(calibrating); });
    if (recording_app->parsed()) return Task([recording] { return record_device(recording); });
    if (configuring_app->parsed()) return Task([configuring] { return run_config(configuring); });
    if (render->parsed()) return resolve_render(raw, still);
    if (calibrating_camera->parsed()) return Task([seeing] { return calibrate_camera(seeing); });
    if (aligning_camera->parsed()) return Task([seeing] { return align_camera(seeing); });
    if (testing_camera->parsed()) return Task([seeing] { return test_camera(seeing); });
    if (filming_camera->parsed()) return Task([seeing] { return record_camera(seeing); });
    if (test->parsed()) return Task([tried] { return self_test(tried); });
    if (app.get_subcommands().empty() || set_up->parsed()) return resolve_setup(raw, o, setup);
    o.join.role = !join->parsed() ? Role::observer : host ? Role::host : Role::dissector;
    resolve(raw, o);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return o;
}

}  // namespace prosector
