#include "client/app/run/option_groups.h"

#include "client/app/run/option_values.h"
#include "common/former_option_name.h"

namespace prosector {
namespace {

constexpr const char* shaders_help =
    "Folder of shaders to use (default: $PROSECTOR_SHADERS, else the built-in ones)";

CLI::Option* add_detail_option(CLI::App& app, RawOptions& raw) {
  return app
      .add_option(
          "--detail", raw.detail,
          "Largest level-of-detail error on the screen, pixels; 0 = full detail (default: set by --quality)")
      ->check(CLI::Range(0.0, 100.0));
}

void add_display(CLI::App& app, RawOptions& raw) {
  app.add_option("--display", raw.display,
                 "Display: window; stereo or stereo:PROFILE (side by side; a name in deploy/stereo, or a "
                 "file); openxr (headset with head and hand tracking); ar or ar:offscreen (the scene over a "
                 "camera image); offscreen; osmesa; none")
      ->capture_default_str()
      ->group("Pictures");
  app.add_option(
         "--camera", raw.camera,
         "Camera for --display ar or --publish-camera: /dev/video0, a number, a video file, a stream, "
         "synthetic:SCENE.toml, or igtl://HOST/DEVICE (default: the tracker's camera)")
      ->group("Pictures");
  app.add_option("--window", raw.window,
                 "Show the scene as through a window, from the viewer's eye position, which this device "
                 "tracks, e.g. face:CAMERA (docs/do/window.md)")
      ->group("Pictures");
  app.add_option("--phantom", raw.phantoms,
                 "With --display ar: name of a body with a real counterpart (phantom). It is not drawn, and "
                 "occludes what is behind it (repeatable)")
      ->group("Pictures");
}

void add_quality(CLI::App& app, RenderingOptions& o, RawOptions& raw) {
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
}

void add_size(CLI::App& app, DisplayOptions& o, RawOptions& raw) {
  app.add_option("--size", raw.size, "Frame size, WIDTHxHEIGHT (default 800x600; stereo: from the profile)")
      ->group("Pictures");
  app.add_option("--monitor", o.monitor,
                 "Show full screen on the monitor with this number, counted from 0 (F11: back to a window)")
      ->check(CLI::NonNegativeNumber)
      ->group("Pictures");
  // As text: CLI11 would convert a missing number to 0.
  CLI::Option* spectators =
      app.add_option_function<std::string>(
             "--spectator-window",
             [&o](const std::string& monitor) {
               o.audience.emplace();
               if (!monitor.empty()) o.audience->monitor = std::stoi(monitor);
             },
             "Open a second window for spectators with the same view (stereo: one eye); with a number, full "
             "screen on that monitor, counted from 0")
          ->expected(0, 1)
          ->type_name("[MONITOR]")
          ->check(CLI::Range(0, 99))
          ->group("Pictures");
  accept_former_name(app, *spectators, "--audience");
  app.add_option("--scale", o.scale,
                 "Scale factor of texts and overlays, 1 = normal size (default: the desktop's, or suited to "
                 "the headset)")
      ->check(CLI::Range(0.5, 8.0))
      ->group("Pictures");
  app.add_option("--fps", o.frames_per_second, "Maximum frames per second")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 240.0))
      ->group("Pictures");
}

void add_views(CLI::App& app, ViewOptions& o) {
  app.add_option("--follow", o.follow, "Show the view of the participant with this name")->group("Pictures");
  app.add_option("--inset", o.insets,
                 "Show the view of the participant with this name as an inset (repeatable)")
      ->group("Pictures");
}

void add_recording(CLI::App& app, OutputOptions& o, RawOptions& raw) {
  app.add_option(
         "--screenshot", raw.screenshots,
         "Write a screenshot (PNG) at the end, or with FILE@SECONDS at that time after joining (repeatable)")
      ->group("Pictures");
  app.add_option("--record", o.video,
                 "Record the display to this video file, .avi or .mp4 (headset: the left eye's frames)")
      ->group("Pictures");
  const auto sheet =
      app.add_option("--sheet", o.sheet,
                     "Write a contact sheet (one PNG with small frames of the whole session) at the end")
          ->group("Pictures");
  CLI::Option* interval =
      app.add_option("--sheet-interval", o.sheet_interval, "Seconds between two frames of the contact sheet");
  interval->capture_default_str()->check(CLI::Range(0.1, 86400.0))->needs(sheet)->group("Pictures");
  accept_former_name(app, *interval, "--every");
}

void add_shaders(CLI::App& app, RenderingOptions& o) {
  app.add_option("--shaders", o.shaders, shaders_help)->group("Pictures");
  app.add_flag("--watch-shaders", o.watch_shaders, "Reload the shaders when a file in their folder changes")
      ->group("Pictures");
}

void add_overlays(CLI::App& app, ViewOptions& o, RawOptions& raw) {
  app.add_flag("!--no-overlay", o.overlay, "Hide figures and axes")->group("Pictures");
  app.add_flag("--wireframes", o.wireframes, "Draw collision shapes as white wireframes")->group("Pictures");
  CLI::Option* color_by = app.add_option(
      "--color-by", raw.show,
      "Colour soft bodies by a quantity: strain, residual (of the solver), error (estimated) or none");
  color_by->capture_default_str()->group("Pictures");
  accept_former_name(app, *color_by, "--show");
}

}  // namespace

void add_pictures(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  add_display(app, raw);
  add_quality(app, o.rendering, raw);
  add_size(app, o.display, raw);
  add_views(app, o.view);
  add_recording(app, o.output, raw);
  add_shaders(app, o.rendering);
  add_overlays(app, o.view, raw);
}

void add_network(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option("--session", o.bus.session, "Name of the session to join")
      ->capture_default_str()
      ->group("Network");
  app.add_option("--domain", o.bus.domain, "DDS domain")
      ->capture_default_str()
      ->check(CLI::Range(0, 230))
      ->group("Network");
  app.add_option("--peer", o.bus.peers,
                 "Look for servers on this machine of the network, HOST or HOST:PORT (repeatable)")
      ->group("Network");
  app.add_option_function<std::vector<std::string>>(
         "--lan",
         [&raw](const std::vector<std::string>& names) { raw.lan = names.empty() ? "" : names.front(); },
         "Look for servers on the local network (default: on this machine only); IFACE selects the network "
         "interface if there are several, e.g. eth0")
      ->expected(0, 1)
      ->type_name("[IFACE]")
      ->group("Network");
  app.add_option("--profile", o.bus.profile,
                 "Network profile: loopback, lan, wan or a DDS profile file (docs/do/network.md)")
      ->group("Network");
  CLI::Option* timeout = app.add_option_function<double>(
      "--timeout",
      [&o](double s) { o.join.time_limit = std::chrono::milliseconds(static_cast<int>(1e3 * s)); },
      "Seconds to look for the session before giving up (default 5)");
  timeout->check(CLI::Range(0.1, 600.0))->group("Network");
  accept_former_name(app, *timeout, "--patience");
}

void add_offers(CLI::App& app, RawOptions& raw) {
  CLI::Option* poses = app.add_option(
      "--publish", raw.offers,
      "Publish the poses of hands, heads and held tools to other software (repeatable): vrpn or igtl "
      "(OpenIGTLink) for this machine only, or vrpn:ADDRESS:PORT");
  poses->group("Network");
  accept_former_name(app, *poses, "--offer");
  CLI::Option* images = app.add_flag(
      "--publish-camera", raw.offers_camera,
      "With --publish igtl: also publish the images of --camera (default: the tracker's camera) as IMAGE "
      "messages");
  images->needs(poses)->group("Network");
  accept_former_name(app, *images, "--offer-camera");
}

void add_run(CLI::App& app, ClientOptions& o, RawOptions& raw) {
  app.add_option("--name", raw.user_name, "Your name, as others see it (default: your login name)");
  app.add_option("--language", raw.language,
                 "Language tag for messages, help and part names, e.g. de, tr (default: from the locale)");
  app.add_option("--seconds", o.seconds,
                 "Leave the session after this many seconds (default: stay until you leave)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--summary", o.logs.summary, "Write a summary of this run to this JSON file")
      ->group("Measurement");
  app.add_option(
         "--session-log", o.logs.session,
         "Write session events (grasps, parts, panels, hand forces) to this file, one JSON object per line")
      ->group("Measurement");
  app.add_option("--latency-log", o.logs.latency,
                 "Write the times of sent inputs (join) or received snapshots (observe) to this CSV file")
      ->group("Measurement");
  CLI::Option* frame_log = app.add_option(
      "--frame-log", o.logs.pictures,
      "With --display ar: write to this CSV file when each frame was drawn, and its camera image, hand pose "
      "and tick");
  frame_log->group("Measurement");
  accept_former_name(app, *frame_log, "--picture-log");
}

void add_devices(CLI::App& app, RawOptions& raw) {
  app.add_option("--tracker", raw.tracker,
                 "Tracker of hands, head and tools, DRIVER:PATH, e.g. fastrak:/dev/ttyS0")
      ->group("Devices");
  app.add_option("--glove", raw.glove,
                 "Glove of the right hand, DRIVER:PATH, e.g. 5dt:/dev/ttyS1 or 5dt-usb:/dev/hidraw0")
      ->group("Devices");
  app.add_option("--glove-left", raw.glove_left, "Left glove")->group("Devices");
  app.add_option("--arm", raw.arm,
                 "Haptic arm that the right hand holds, DRIVER:PATH, e.g. omni-twin:/tmp/omni")
      ->group("Devices");
  app.add_option("--config", raw.config,
                 "Client configuration file with the devices and their settings; sample: deploy/client.toml")
      ->check(CLI::ExistingFile)
      ->group("Devices");
}

void add_render(CLI::App& app, RenderOptions& o, RawOptions& raw) {
  app.add_option("SCENE", o.scene, "Scene file, e.g. deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  app.add_option("--out", o.out, "Output folder; created if missing")->required();
  app.add_option("--view", o.view, "Render only this view, e.g. close (default: all)");
  app.add_flag("--compare", o.compare,
               "Also render each view with each rendering effect toggled, where this changes the frame");
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
  app.add_option("--config", setup.config,
                 "Client configuration file to edit; created on saving if it does not exist");
  app.add_option("--size", raw.size, "Window size, WIDTHxHEIGHT (default 1280x720)");
  app.add_option("--scale", setup.scale,
                 "Scale factor of texts and controls, 1 = normal size (default: the desktop's)")
      ->check(CLI::Range(0.5, 8.0));
  app.add_option("--layout-log", setup.layout_log,
                 "Write the positions of the window's controls to this JSON file whenever they change, for "
                 "scripts that operate it");
  app.add_option("--shaders", setup.shaders, shaders_help);
}

}  // namespace prosector
