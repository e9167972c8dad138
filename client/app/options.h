#pragma once
// What the command line of prosector-client says.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/app/camera_command.h"
#include "client/app/config_watch.h"
#include "client/app/connection.h"
#include "client/app/device_rig.h"
#include "client/app/render_scene.h"
#include "client/app/self_test.h"
#include "client/language/catalogue.h"
#include "client/offer/offer_protocol.h"
#include "client/render/renderer.h"
#include "client/render/window_context.h"
#include "client/view/stereo_profile.h"
#include "client/view/value_paint.h"
#include "drivers/client_config.h"

namespace prosector {

enum class Display : std::uint8_t { window, stereo, openxr, offscreen, osmesa, none };

struct Screenshot {
  std::filesystem::path file;
  std::optional<double> at;  // s after joining; nullopt: at the end
};

struct ClientOptions {
  BusConfig bus;
  Catalogue words;  // in the language of join.language
  JoinRequest join;
  ConfigSource source;  // of `devices`
  ClientConfig devices;
  Display display = Display::window;
  StereoProfile stereo;               // with Display::stereo
  std::string camera;                 // address of the one to look through; empty: none
  std::vector<std::string> phantoms;  // names of bodies that are really there, before that camera
  QualityLevel quality = quality_levels[1];
  int width = 800, height = 600;
  std::optional<double> frame_time;  // s a picture, by which quality is picked anew; nullopt: it stays
  std::optional<int> monitor;        // to fill, from 0; nullopt: a window
  std::optional<Audience> audience;  // a second window; nullopt: none
  std::optional<double> scale;       // of what lies over pictures; nullopt: as the desktop says, else 1
  double frames_per_second = 30;
  double seconds = 0;               // 0: until ended
  std::string follow;               // name of the participant whose eyes to look through; empty: own camera
  std::vector<std::string> insets;  // names of participants whose views are seen small
  std::vector<Screenshot> screenshots;
  double sheet_interval = 10;  // s between two pictures of `sheet`
  std::filesystem::path record, sheet, latency_log, picture_log, session_log, summary, shaders;
  std::vector<Offer> offers;   // of poses to other software
  std::string offered_camera;  // address of one whose pictures are offered, too; empty: none
  bool overlay = true;         // figures and axes
  bool watch_shaders = false;  // read anew whenever one is written
  bool wireframes = false;     // of what bodies collide as; a desk user's C key changes it
  Shown shown = Shown::none;   // by soft bodies' colours; a desk user's V key changes it
};

/// Returns the address of the camera that is looked through, or that sees the eyes; empty: none is.
std::string used_camera(const ClientOptions& options);

/// Tells whether devices or a headset say where the user's hands are, or who looks through a camera has none.
inline bool is_tracked(const ClientOptions& options) {
  return has_devices(options.devices) || options.display == Display::openxr || !options.camera.empty();
}

/// A command that joins no session: what it does, and its exit code.
using Task = std::function<int()>;

/// What the set-up window is told.
struct SetupOptions {
  BusConfig bus;
  std::string name;      // until somebody gives another one
  std::string language;  // tag that was asked for; empty: the locale's
  Catalogue words;       // of that language
  std::filesystem::path scenes,
      config;  // folder of scenes to host, the client's configuration; empty: the usual
  std::filesystem::path shaders, layout_log;
  int width = 1280, height = 720;
  std::optional<double> scale;  // nullopt: as the desktop says
};

using ClientCommand = std::variant<SetupOptions, ClientOptions, RenderOptions, Task, int>;

/// Parses; on --help or a wrong line prints to the user and returns the exit code.
ClientCommand parse_command_line(int argc, char** argv);

}  // namespace prosector
