#pragma once
// The client's configuration file (TOML): which devices, how they stand in the room, what gestures do.
// client_config_table.h has every key; deploy/client.toml is a documented sample.

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "common/messages.h"
#include "drivers/arm.h"
#include "drivers/device.h"

namespace prosector {

/// What a tracker's receiver is fixed to. `instrument`: what touches points when the tracker is calibrated,
/// and panels in a session; no hand. `tablet`: a board that is the user's panel.
enum class StationRole : std::uint8_t { none, head, left_hand, right_hand, instrument, tablet };

/// What making a gesture asks for. `panel`: the panel of the part that the hand touches or points at, or away
/// with one's own that is open. `parts`: the list of parts on a board, or away with it.
enum class GestureEvent : std::uint8_t { none, grasp, release, reset, panel, parts };

struct GloveSettings {
  std::string address;  // empty: no such glove
  DeviceConfig device;
};

struct ArmSettings {
  std::string address;            // empty: no arm
  std::size_t hand = right_hand;  // that it moves
  ArmConfig arm;
  std::optional<Pose>
      mount;              // of the wrist in the stylus' frame; none: the index finger's tip is the stylus'
  unsigned dead_man = 0;  // the button, from 1, without which there is no force; 0: none is needed
};

/// What was measured of a user's eyes and display; each takes the place of the stereo profile's.
struct EyeSettings {
  std::optional<double> distance;                      // m, between the pupils
  std::optional<double> fov_horizontal, fov_vertical;  // rad, each eye
  std::optional<double> convergence;                   // m: where both pictures coincide
};

/// A screen through which a desk user looks as through a window: whose eyes are seen, and from where.
struct WindowSettings {
  std::string address;  // of a device whose station 1 is between the eyes; empty: none
  DeviceConfig device;  // its room is the screen's frame: from its middle x right, y up, z to the user
  double height = 0.3;  // m, of the picture on the screen
  bool pans = false;    // the face turns the view; else the screen is a window

  WindowSettings() { device.room_device = {{0, 0.17, 0}, Quat(0, 0, 1, 0)}; }
};

/// A real body of a known shape, which hides virtual things behind it.
struct PhantomSettings {
  std::string body;   // of the scene, whose shape it has; empty: `mesh` says
  std::string mesh;   // file of its shape; both empty: there is no phantom
  double scale = 1;   // m of a unit of that file
  std::string board;  // fixed to it, a known board's name or a file; empty: it stands still in the room
  std::optional<Pose> pose;  // of the shape, in the board's frame, or in the room; nullopt: wasn't found

  bool has_shape() const { return !body.empty() || !mesh.empty(); }
  /// Tells whether it has a place of its own, and not the scene's.
  bool has_place() const { return pose || !board.empty(); }
};

struct ClientConfig {
  std::string tracker;  // address; empty: no tracker
  DeviceConfig tracker_device;
  std::array<StationRole, max_stations> stations{StationRole::right_hand};
  std::string tool;  // blade of the scene that the instrument is in a session; empty: it presses panels alone
  std::array<GloveSettings, 2> gloves;  // left_hand, right_hand; `left` is set
  ArmSettings arm;
  Pose headset_room;  // pose of an OpenXR headset's stage in the room
  EyeSettings eyes;
  WindowSettings window;
  PhantomSettings phantom;
  std::map<Gesture, GestureEvent> gestures = {{Gesture::fist, GestureEvent::grasp},
                                              {Gesture::pinch, GestureEvent::grasp},
                                              {Gesture::flat, GestureEvent::release},
                                              {Gesture::index_little, GestureEvent::panel},
                                              {Gesture::three, GestureEvent::parts}};

  ClientConfig() {
    gloves[left_hand].device.left = true;
    tracker_device.boards[0] = "wrist-right";
  }
};

/// Reads the client's configuration, and checks the files that it names. Throws InputError with file, line,
/// key and what is allowed; unknown keys are errors.
ClientConfig load_client_config(const std::filesystem::path& file);
/// Reads the configuration from text; `file` is for messages, and files that it names are looked for beside
/// it.
ClientConfig parse_client_config(std::string_view toml, const std::string& file);

}  // namespace prosector
