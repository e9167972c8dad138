#pragma once
// Command-line options of prosector-client.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/app/commands/camera_command.h"
#include "client/app/commands/render_scene.h"
#include "client/app/commands/self_test.h"
#include "client/app/session/connection.h"
#include "client/app/user/config_watch.h"
#include "client/app/user/device_rig.h"
#include "client/language/catalogue.h"
#include "client/offer/offer_protocol.h"
#include "client/render/renderer.h"
#include "client/render/window_context.h"
#include "client/view/stereo_profile.h"
#include "client/view/value_paint.h"
#include "drivers/config/client_config.h"

namespace prosector {

enum class Display : std::uint8_t { window, stereo, openxr, offscreen, osmesa, none };

struct Screenshot {
  std::filesystem::path file;
  std::optional<double> at;  // s after joining; nullopt: at the end
};

struct ClientOptions {
  BusConfig bus;
  Catalogue words;  // messages in the language of join.language
  JoinRequest join;
  ConfigSource source;  // source of `devices`
  ClientConfig devices;
  Display display = Display::window;
  StereoProfile stereo;               // used with Display::stereo
  std::string camera;                 // address of the camera for augmented reality; empty: none
  std::vector<std::string> phantoms;  // names of bodies that are physically present in front of that camera
  QualityLevel quality = quality_levels[1];
  int width = 800, height = 600;
  std::optional<double> frame_time;  // target frame time for automatic quality, s; nullopt: fixed quality
  std::optional<int> monitor;        // index of the monitor for full screen, from 0; nullopt: a window
  std::optional<Audience> audience;  // second window for an audience; nullopt: none
  std::optional<double> scale;       // scale of overlays; nullopt: the desktop's, else 1
  double frames_per_second = 30;
  double seconds = 0;               // duration of the session; 0: until ended by the user
  std::string follow;               // name of the participant whose eyes give the view; empty: own camera
  std::vector<std::string> insets;  // names of participants whose views are shown as insets
  std::vector<Screenshot> screenshots;
  double sheet_interval = 10;  // s between two images of `sheet`
  std::filesystem::path record, sheet, latency_log, picture_log, session_log, summary, shaders;
  std::vector<Offer> offers;   // servers of poses for other software
  std::string offered_camera;  // address of a camera whose images are also offered; empty: none
  bool overlay = true;         // statistics and axes
  bool watch_shaders = false;  // reload shaders when a file changes
  bool wireframes = false;     // of the bodies' collision shapes; a desk user's C key toggles them
  Shown shown = Shown::none;   // quantity shown by soft bodies' colours; a desk user's V key changes it
};

/// Returns the address of the camera that is used for augmented reality or, without it, for eye tracking;
/// empty if there is none.
std::string used_camera(const ClientOptions& options);

/// Returns whether the user's hands are tracked rather than driven by the mouse. This is so with tracking
/// devices, with a headset, and in augmented reality over a camera's images.
inline bool is_tracked(const ClientOptions& options) {
  return has_devices(options.devices) || options.display == Display::openxr || !options.camera.empty();
}

/// Parsed command that joins no session, such as a calibration. Calling it runs the command and returns the
/// program's exit code.
using Task = std::function<int()>;

/// Command-line options with which the set-up window starts.
struct SetupOptions {
  BusConfig bus;
  std::string name;      // default, until the user enters another name
  std::string language;  // requested tag; empty: the locale's
  Catalogue words;       // messages in that language
  std::filesystem::path scenes,
      config;  // folder of scenes to host, client configuration; empty: the defaults
  std::filesystem::path shaders, layout_log;
  int width = 1280, height = 720;
  std::optional<double> scale;  // nullopt: the desktop's
};

using ClientCommand = std::variant<SetupOptions, ClientOptions, RenderOptions, Task, int>;

/// Parses the client's command line. Returns the command to run with its options. For --help or an invalid
/// line, prints a text for the user and returns the program's exit code instead.
ClientCommand parse_command_line(int argc, char** argv);

}  // namespace prosector
