#include "client/app/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>

#include "client/app/calibrate.h"
#include "client/app/config_command.h"
#include "client/app/record_camera.h"
#include "client/app/record_device.h"
#include "client/render/shader_dir.h"
#include "common/error.h"
#include "common/local_name.h"
#include "common/version.h"

namespace prosector {
namespace {

constexpr const char* shaders_help =
    "Draw with this folder's shaders (default: $PROSECTOR_SHADERS, else the program's own)";

const std::map<std::string, Display> displays = {
    {"window", Display::window},       {"stereo", Display::stereo}, {"openxr", Display::openxr},
    {"offscreen", Display::offscreen}, {"osmesa", Display::osmesa}, {"none", Display::none}};

struct RawOptions {
  std::string tracker, glove, glove_left, arm, config, size, camera, window, user_name, language,
      display = "window", quality = "medium", show = "none";
  std::optional<std::string> lan;  // empty: the only network that there is
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
  app.add_option("--session", o.bus.session, "Name of the session to find")
      ->capture_default_str()
      ->group("Network");
  app.add_option("--domain", o.bus.domain, "DDS domain")
      ->capture_default_str()
      ->check(CLI::Range(0, 230))
      ->group("Network");
  app.add_option("--peer", o.bus.peers, "A server's machine, HOST or HOST:PORT (repeatable)")
      ->group("Network");
  app.add_option_function<std::vector<std::string>>(
         "--lan",
         [&raw](const std::vector<std::string>& names) { raw.lan = names.empty() ? "" : names.front(); },
         "Search the local network; of this interface, for instance eth0, where there are several")
      ->expected(0, 1)
      ->type_name("[IFACE]")
      ->group("Network");
  app.add_option("--profile", o.bus.profile, "loopback, lan, wan or a DDS profile file: docs/do/network.md")
      ->group("Network");
  app.add_option_function<double>(
         "--patience",
         [&o](double s) { o.join.patience = std::chrono::milliseconds(static_cast<int>(1e3 * s)); },
         "Seconds to look for the session (default 5)")
      ->check(CLI::Range(0.1, 600.0))
      ->group("Network");
}

CLI::Option* add_detail_option(CLI::App& app, RawOptions& raw) {
  return app
      .add_option("--detail", raw.detail,
                  "Pixels by which surfaces may be off to be drawn with fewer triangles; 0: never (default: "
                  "the quality's)")
      ->check(CLI::Range(0.0, 100.0));
}

void add_offers(CLI::App& app, RawOptions& raw) {
  app.add_option(
         "--offer", raw.offers,
         "Offer hands, heads and held tools to other software (repeatable): vrpn or igtl, on this machine "
         "alone; vrpn:ADDRESS:PORT")
      ->group("Network");
  app.add_flag("--offer-camera", raw.offers_camera,
               "Offer the pictures of --camera, or of the tracker's, too: by igtl, as IMAGE")
      ->needs("--offer")
      ->group("Network");
}

void add_pictures(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option(
         "--display", raw.display,
         "window, stereo or stereo:PROFILE (side by side; a name in deploy/stereo, or a file), openxr (a "
         "headset, with head and hands), ar or ar:offscreen (what a camera sees, the scene on its table), "
         "offscreen, osmesa, none")
      ->capture_default_str()
      ->group("Pictures");
  app.add_option("--camera", raw.camera,
                 "With --display ar or --offer-camera: /dev/video0, a number, a video's file, a stream, "
                 "synthetic:SCENE.toml, or igtl://HOST/DEVICE (default: the tracker's, where that is a "
                 "camera's)")
      ->group("Pictures");
  app.add_option("--window", raw.window,
                 "The screen is a window into the room, for the eyes that this device sees: face:CAMERA as "
                 "with --tracker (docs/do/window.md)")
      ->group("Pictures");
  app.add_option(
         "--phantom", raw.phantoms,
         "With --display ar: name of a body that really lies there, as a phantom does: it is left out, and "
         "hides what is behind it; may be given again")
      ->group("Pictures");
  app.add_option("--quality", raw.quality, "Of pictures: low, medium, high")
      ->capture_default_str()
      ->group("Pictures");
  app.add_option_function<double>(
         "--frame-time", [&o](double ms) { o.frame_time = 1e-3 * ms; },
         "Pick the quality by what a picture may take, ms; --quality, --effect and --detail don't count then")
      ->check(CLI::Range(1.0, 1000.0))
      ->group("Pictures");
  app.add_option("--effect", raw.effects, "NAME=on or NAME=off (repeatable): " + effect_names(", "))
      ->group("Pictures");
  add_detail_option(app, raw)->group("Pictures");
  app.add_option("--size", raw.size, "Picture size, WIDTHxHEIGHT (default 800x600; stereo: the profile's)")
      ->group("Pictures");
  app.add_option("--monitor", o.monitor, "Fill this monitor, counted from 0 (F11: back to a window)")
      ->check(CLI::NonNegativeNumber)
      ->group("Pictures");
  // As text: CLI11 makes the number 0 of none.
  app.add_option_function<std::string>(
         "--audience",
         [&o](const std::string& monitor) {
           o.audience.emplace();
           if (!monitor.empty()) o.audience->monitor = std::stoi(monitor);
         },
         "A second window with the same picture, in stereo of one eye, for others to watch; or fill this "
         "monitor with it")
      ->expected(0, 1)
      ->type_name("[MONITOR]")
      ->check(CLI::Range(0, 99))
      ->group("Pictures");
  app.add_option(
         "--scale", o.scale,
         "Size of texts and overlays (default: as the desktop scales its own, or as a headset's eyes need)")
      ->check(CLI::Range(0.5, 8.0))
      ->group("Pictures");
  app.add_option("--fps", o.frames_per_second, "Pictures per second, at most")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 240.0))
      ->group("Pictures");
  app.add_option("--follow", o.follow, "See through the eyes of the participant of this name")
      ->group("Pictures");
  app.add_option("--inset", o.insets, "Show the view of the participant of this name, small (repeatable)")
      ->group("Pictures");
  app.add_option("--screenshot", raw.screenshots,
                 "PNG at the end, or FILE@SECONDS after joining (repeatable)")
      ->group("Pictures");
  app.add_option("--record", o.record, "Video file, .avi or .mp4; of a headset the left eye's")
      ->group("Pictures");
  const auto sheet =
      app.add_option("--sheet", o.sheet, "PNG of small pictures of the session, written at its end")
          ->group("Pictures");
  app.add_option("--every", o.sheet_interval, "Seconds between two pictures of the sheet")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0))
      ->needs(sheet)
      ->group("Pictures");
  app.add_option("--shaders", o.shaders, shaders_help)->group("Pictures");
  app.add_flag("--watch-shaders", o.watch_shaders,
               "Read the shaders anew whenever one of their folder is written")
      ->group("Pictures");
  app.add_flag("!--no-overlay", o.overlay, "Leave out figures and axes")->group("Pictures");
  app.add_flag("--wireframes", o.wireframes, "Draw what bodies collide as, in white lines")
      ->group("Pictures");
  app.add_option("--show", raw.show, "Colour soft bodies by strain, residual or error, or not: none")
      ->capture_default_str()
      ->group("Pictures");
}

void add_run(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option("--name", raw.user_name, "Your name, as others see it (default: your login name)");
  app.add_option("--language", raw.language,
                 "Tag of the language of messages, help and parts' names, for instance de, tr (default: the "
                 "locale's)");
  app.add_option("--seconds", o.seconds, "Leave after this long (default: stay)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--summary", o.summary, "Write figures of this run as JSON")->group("Measurement");
  app.add_option("--session-log", o.session_log,
                 "Write what happens as lines of JSON: who holds what, parts, panels, forces of hands")
      ->group("Measurement");
  app.add_option("--latency-log", o.latency_log, "Write times of inputs sent or snapshots received as CSV")
      ->group("Measurement");
  app.add_option("--picture-log", o.picture_log,
                 "With --display ar: write when each picture was drawn and what it showed as CSV")
      ->group("Measurement");
}

void add_devices(CLI::App& app, RawOptions& raw) {
  app.add_option("--tracker", raw.tracker, "Tracker: DRIVER:PATH, for instance fastrak:/dev/ttyS0")
      ->group("Devices");
  app.add_option("--glove", raw.glove, "Right glove: for instance 5dt:/dev/ttyS1 or 5dt-usb:/dev/hidraw0")
      ->group("Devices");
  app.add_option("--glove-left", raw.glove_left, "Left glove")->group("Devices");
  app.add_option("--arm", raw.arm, "Haptic arm of the right hand: for instance omni-twin:/tmp/omni")
      ->group("Devices");
  app.add_option("--config", raw.config, "Client configuration, see deploy/client.toml")
      ->check(CLI::ExistingFile)
      ->group("Devices");
}

void add_render(CLI::App& app, RenderOptions& o, RawOptions& raw) {
  app.add_option("SCENE", o.scene, "Scene file, for instance deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  app.add_option("--out", o.out, "Folder for the pictures; made if missing")->required();
  app.add_option("--view", o.view, "Only this one, for instance close (default: all)");
  app.add_flag("--compare", o.compare, "Also each effect the other way, where it shows");
  app.add_flag("--sheet", o.sheet, "Also all pictures on one, small");
  app.add_option("--turntable", o.turntable, "Also a video of one turn, of this many seconds")
      ->check(CLI::Range(0.1, 600.0));
  app.add_flag("--osmesa", o.osmesa, "Draw with OSMesa, even where there is EGL");
  app.add_option("--quality", raw.quality, "low, medium, high")->capture_default_str();
  app.add_option("--effect", raw.effects, "NAME=on or NAME=off (repeatable): " + effect_names(", "));
  add_detail_option(app, raw);
  app.add_option("--size", raw.size, "Picture size, WIDTHxHEIGHT (default 640x480)");
  app.add_option("--shaders", o.shaders, shaders_help);
}

void add_setup(CLI::App& app, SetupOptions& setup, ClientOptions& o, RawOptions& raw) {
  add_network(app, o, raw);
  app.add_option("--name", raw.user_name, "Your name, until you give another one (default: your login name)");
  app.add_option("--language", raw.language,
                 "Tag of the window's and sessions' language, for instance de, tr (default: the locale's)");
  app.add_option("--scenes", setup.scenes, "Folder of scenes to host (default: those of the program)")
      ->check(CLI::ExistingDirectory);
  app.add_option("--config", setup.config, "The client's configuration, which need not be there yet");
  app.add_option("--size", raw.size, "Of the window, WIDTHxHEIGHT (default 1280x720)");
  app.add_option("--scale", setup.scale,
                 "Size of letters and controls (default: as the desktop scales its own)")
      ->check(CLI::Range(0.5, 8.0));
  app.add_option("--layout-log", setup.layout_log,
                 "Write where controls are as JSON, whenever that changes: for scripts that click");
  app.add_option("--shaders", setup.shaders, shaders_help);
}

void add_self_test(CLI::App& app, SelfTestOptions& o) {
  app.add_option("ADDRESS", o.address,
                 "The device: DRIVER:PATH, for instance 5dt-usb:/dev/hidraw0; with --config also tracker, "
                 "glove.right, glove.left (default: the first that it names)");
  app.add_option("--config", o.config, "Client configuration: address, receivers, place, counts")
      ->check(CLI::ExistingFile);
  app.add_option("--seconds", o.seconds, "How long it is recorded")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--out", o.out, "The report; the samples are beside it, as .csv")->capture_default_str();
}

void parse_size(const std::string& text, int& width, int& height) {
  const auto x = text.find('x');
  const auto number = [&](std::size_t from, std::size_t to, int& out) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, out);
    return error == std::errc() && end == text.data() + to && out >= 16 && out <= 8192;
  };
  if (x == std::string::npos || !number(0, x, width) || !number(x + 1, text.size(), height))
    throw InputError("--size " + text + ": give WIDTHxHEIGHT, each 16 to 8192, for instance 800x600");
}

/// Reads DISPLAY, stereo:PROFILE or ar:DISPLAY; a profile brings its picture size. Returns whether it is to
/// be looked through a camera.
bool parse_display(const std::string& text, ClientOptions& o) {
  const auto colon = text.find(':');
  if (text == "ar" || text == "ar:offscreen") {
    o.display = text == "ar" ? Display::window : Display::offscreen;
    return true;
  }
  const auto found = displays.find(text.substr(0, colon));
  if (found == displays.end() || (colon != std::string::npos && found->second != Display::stereo))
    throw InputError("--display " + text +
                     ": give window, stereo, stereo:PROFILE, openxr, ar, ar:offscreen, offscreen, osmesa or "
                     "none");
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
        fmt::format("--effect {}: give NAME=on or NAME=off, with NAME {}", text, effect_names(", ")));
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
  throw InputError("--quality " + raw.quality + ": give low, medium or high");
}

Shown parse_shown(const std::string& text) {
  for (std::size_t k = 0; k < value_scales.size(); ++k)
    if (value_scales[k].name == text) return static_cast<Shown>(k);
  throw InputError("--show " + text + ": give strain, residual, error or none");
}

Screenshot parse_screenshot(const std::string& text) {
  const auto at = text.rfind('@');
  if (at == std::string::npos) return {text, std::nullopt};
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data() + at + 1, text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || !(seconds >= 0))
    throw InputError("--screenshot " + text + ": after @ comes a number of seconds");
  return {text.substr(0, at), seconds};
}

std::string login_name() {
  const char* user = std::getenv("USER");
  return user != nullptr && *user != '\0' ? user : "guest";
}

/// Returns the language of the environment's messages, by POSIX' order of its variables.
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
    throw InputError("--language " + text + ": must be a language tag, for instance de, tr, pt-BR");
  return tag;
}

RenderOptions resolve_render(const RawOptions& raw, RenderOptions o) {
  if (!raw.size.empty()) parse_size(raw.size, o.width, o.height);
  o.quality = parse_quality(raw);
  if (o.shaders.empty()) o.shaders = default_shader_dir();
  return o;
}

/// Says how the network is reached that options name.
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

/// Lets what was measured of the eyes take the place of the profile's.
void take_eyes(const EyeSettings& eyes, StereoProfile& profile) {
  profile.eye_distance = eyes.distance.value_or(profile.eye_distance);
  profile.fov_horizontal = eyes.fov_horizontal.value_or(profile.fov_horizontal);
  profile.fov_vertical = eyes.fov_vertical.value_or(profile.fov_vertical);
  profile.convergence = eyes.convergence.value_or(profile.convergence);
}

/// Refuses a window into the room where there is no screen that could be one.
void check_window(const ClientOptions& o) {
  const bool fits =
      o.display == Display::window || o.display == Display::offscreen || o.display == Display::osmesa;
  if (!o.devices.window.address.empty() && (!fits || !o.camera.empty()))
    throw InputError(
        "--window, or [window] of the configuration: only with --display window, offscreen or "
        "osmesa");
}

/// Returns the camera that is named, or the tracker's. `wants`: the option that needs one.
std::string resolve_camera(const RawOptions& raw, const ClientOptions& o, const char* wants) {
  const std::string camera = raw.camera.empty() ? first_camera(o.devices.tracker) : raw.camera;
  if (camera.empty())
    throw InputError(fmt::format("{}: say with --camera which one, for instance /dev/video0", wants));
  return camera;
}

/// Adds what is done with a camera. Returns the commands: calibrate, selftest, align, record.
std::array<CLI::App*, 4> add_camera(CLI::App& camera, CameraCommandOptions& o) {
  camera.require_subcommand(1);
  CLI::App* calibrate =
      camera.add_subcommand("calibrate", "Find the lens: show the camera a board, as it asks for");
  CLI::App* test =
      camera.add_subcommand("selftest", "Say what the pictures are like: rate, light, noise, boards");
  CLI::App* align =
      camera.add_subcommand("align", "Find where the camera stands, by a board on a tracker's receiver");
  CLI::App* record = camera.add_subcommand("record", "Keep its pictures as a film, which is a camera again");
  for (CLI::App* command : {calibrate, test, align, record})
    command
        ->add_option("CAMERA", o.camera,
                     "Number or path of a device, a video's file, a stream's URL, or synthetic:SCENE.toml")
        ->capture_default_str();
  for (CLI::App* command : {calibrate, align}) {
    command->add_option("--board", o.board, "The board that is shown: a known one, or a file")
        ->capture_default_str();
    command->add_option("--patience", o.patience, "Give up after so many seconds")->capture_default_str();
  }
  calibrate->add_option("--out", o.out, "File to write")->required();
  CLI::Option* second = calibrate->add_option(
      "--second", o.second, "Another camera beside it: both lenses, and how the cameras stand to each other");
  calibrate
      ->add_option("--out-config", o.out_config, "Configuration that gets both lenses and tracker.second")
      ->check(CLI::ExistingFile)
      ->needs(second);
  test->add_option("--out", o.out, "File for the report");
  for (CLI::App* command : {test, align})
    command->add_option("--lens", o.lens, "The camera's calibration")->check(CLI::ExistingFile);
  align->add_option("--tracker", o.tracker, "DRIVER:PATH of the tracker")->required();
  align->add_option("--tracker-config", o.tracker_config, "Configuration that says where the tracker stands")
      ->check(CLI::ExistingFile);
  align->add_option("--station", o.station, "The receiver that wears the board")
      ->check(CLI::Range(std::size_t{1}, max_stations))
      ->capture_default_str();
  align->add_option("--poses", o.poses, "How often the board is held still")
      ->check(CLI::Range(least_tracked_pairs, std::size_t{200}))
      ->capture_default_str();
  align->add_option("--out-config", o.out_config, "Configuration that gets the camera's place, tracker.room")
      ->check(CLI::ExistingFile)
      ->required();
  record->add_option("--out", o.out, "Film to write: .avi")->required();
  for (CLI::App* command : {test, record})
    command->add_option("--seconds", o.seconds, "How long it is looked at")
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
      throw InputError("--display ar: shows what the camera sees, without --follow and --inset");
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
    throw InputError("phantom.mesh: say where it is, by phantom.board or as `calibrate phantom` finds it");
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
    throw InputError("--watch-shaders: name the folder to watch with --shaders");
}

}  // namespace

std::string used_camera(const ClientOptions& options) {
  return options.camera.empty() ? first_camera(options.devices.window.address) : options.camera;
}

ClientCommand parse_command_line(int argc, char** argv) {
  ClientOptions o;
  RawOptions raw;
  CLI::App app{
      "Join or watch a dissecting room that a prosector-server hosts.\n"
      "  prosector-client                                           a window to find, host and enter "
      "sessions\n"
      "  prosector-client join --name NAME                          mouse and keyboard drive your hand\n"
      "  prosector-client join --name NAME --tracker fastrak:/dev/ttyS0 --glove 5dt:/dev/ttyS1 --display "
      "stereo\n"
      "  prosector-client observe --follow NAME --record session.avi\n"
      "  prosector-client render SCENE --out DIR                    pictures of a scene file, no server",
      "prosector-client"};
  app.set_version_flag("--version", version_line("prosector-client"));
  app.require_subcommand(0, 1);
  SetupOptions setup;
  CLI::App* set_up = app.add_subcommand("setup", "The set-up window; also what comes without a command");
  add_setup(*set_up, setup, o, raw);
  CLI::App* join = app.add_subcommand("join", "Take part: touch, hold and move");
  CLI::App* observe = app.add_subcommand("observe", "Watch: can disturb nothing, may come at any moment");
  for (CLI::App* command : {join, observe}) {
    add_run(*command, o, raw);
    add_network(*command, o, raw);
    add_offers(*command, raw);
    add_pictures(*command, o, raw);
  }
  add_devices(*join, raw);
  CLI::App* render = app.add_subcommand("render", "Pictures of a scene file, without a server");
  RenderOptions still;
  add_render(*render, still, raw);
  CalibrateOptions calibrating;
  CLI::App* calibrating_app =
      app.add_subcommand("calibrate", "Guided steps: tracker, instrument, glove, eyes");
  add_calibrate(*calibrating_app, calibrating);
  RecordOptions recording;
  CLI::App* recording_app = app.add_subcommand("record", "A device's samples into a file, without a server");
  add_record(*recording_app, recording);
  ConfigOptions configuring;
  CLI::App* configuring_app = app.add_subcommand("config", "Check or change a configuration");
  add_config(*configuring_app, configuring);
  CLI::App* test = app.add_subcommand("selftest", "Record a device, and say what of it fits its protocol");
  SelfTestOptions tried;
  add_self_test(*test, tried);
  CameraCommandOptions seeing;
  CLI::App* camera = app.add_subcommand("camera", "Calibrate a camera, or say what its pictures are like");
  const auto [calibrating_camera, testing_camera, aligning_camera, filming_camera] =
      add_camera(*camera, seeing);
  bool host = false;
  join->add_flag("--host", host, "Be the session's host, who hands out roles, unless it has one");
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
