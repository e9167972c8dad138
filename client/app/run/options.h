#pragma once
// Command-line options of prosector-client.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "client/app/commands/camera_command.h"
#include "client/app/commands/render_scene.h"
#include "client/app/commands/self_test.h"
#include "client/app/run/ar_options.h"
#include "client/app/run/display_options.h"
#include "client/app/run/log_options.h"
#include "client/app/run/offer_options.h"
#include "client/app/run/output_options.h"
#include "client/app/run/rendering_options.h"
#include "client/app/run/view_options.h"
#include "client/app/session/connection.h"
#include "client/app/user/config_watch.h"
#include "client/app/user/device_rig.h"
#include "client/language/catalogue.h"
#include "drivers/config/client_config.h"

namespace prosector {

struct ClientOptions {
  BusConfig bus;
  Catalogue words;  // messages in the language of join.language
  JoinRequest join;
  double seconds = 0;   // duration of the session; 0: until ended by the user
  ConfigSource source;  // source of `devices`
  ClientConfig devices;
  DisplayOptions display;
  RenderingOptions rendering;
  ArOptions ar;
  ViewOptions view;
  OutputOptions output;
  LogOptions logs;
  OfferOptions offers;
};

/// Returns the address of the camera that is used for augmented reality or, without it, for eye tracking;
/// empty if there is none.
std::string used_camera(const ClientOptions& options);

/// Returns whether the user's hands are tracked rather than driven by the mouse. This is so with tracking
/// devices, with a headset, and in augmented reality over a camera's images.
inline bool is_tracked(const ClientOptions& options) {
  return has_devices(options.devices) || options.display.kind == Display::openxr ||
         !options.ar.camera.empty();
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
