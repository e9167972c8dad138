#pragma once
// The client's configuration file (TOML): devices, their poses in the room, and actions of gestures.
// client_config_table.h defines every key; deploy/client.toml is a documented sample.

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"
#include "drivers/config/device_config.h"
#include "drivers/device/arm.h"

namespace prosector {

/// Object to which a tracker's receiver is attached. `instrument` is a tracked tool that touches points
/// during tracker calibration and presses panels in a session; it is no hand. `tablet` is a hand-held board
/// that serves as the user's panel.
enum class StationRole : std::uint8_t { none, head, left_hand, right_hand, instrument, tablet };

/// Action that a hand gesture triggers. `grasp` and `release` act on the body at the hand. `reset` returns
/// the body that the hand holds, otherwise the body that it held or touched last, to its initial state.
/// `panel` shows or hides the panel of the anatomical part that the hand touches or points at. `parts` shows
/// or hides the board with the list of parts.
enum class GestureEvent : std::uint8_t { none, grasp, release, reset, panel, parts };

struct GloveSettings {
  std::string address;  // empty: no glove
  DeviceConfig device;
};

struct ArmSettings {
  std::string address;            // empty: no arm
  std::size_t hand = right_hand;  // hand that the arm moves
  ArmConfig arm;
  std::optional<Pose> mount;  // pose of the wrist in the stylus frame; none: the index fingertip is at the
                              // stylus tip
  unsigned dead_man = 0;      // button number from 1 that must be held to enable forces; 0: none is needed
};

/// Measured values of the user's eyes and display. Each value that is set overrides that of the stereo
/// profile.
struct EyeSettings {
  std::optional<double> distance;                      // m, interpupillary distance
  std::optional<double> fov_horizontal, fov_vertical;  // rad, field of view of each eye
  std::optional<double> convergence;                   // m: distance at which the images of both eyes
                                                       // coincide
};

/// Settings of a screen that works as a window into the scene for a user at a desk, and of the device that
/// tracks the user's eyes.
struct WindowSettings {
  std::string address;  // of a device whose station 1 is the midpoint between the eyes; empty: none
  DeviceConfig device;  // its room frame is the screen frame: origin in the middle, x right, y up, z to the
                        // user
  double height = 0.3;  // m, of the image on the screen
  bool pans = false;    // true: head motion rotates the view; false: the screen is a window

  WindowSettings() { device.placement.room_device = {{0, 0.17, 0}, Quat(0, 0, 1, 0)}; }
};

/// Settings of a phantom: a physical object of known shape that occludes virtual objects behind it.
struct PhantomSettings {
  std::string body;          // body of the scene with the same shape; empty: `mesh` gives the shape
  std::string mesh;          // file of the shape; both empty: no phantom
  double scale = 1;          // m per unit of the mesh file
  std::string board;         // board fixed to the object, by known name or file; empty: the object is static
  std::optional<Pose> pose;  // pose of the shape in the board frame, or the room frame without a board;
                             // nullopt: not calibrated

  bool has_shape() const { return !body.empty() || !mesh.empty(); }
  /// Returns whether the phantom's pose is configured or follows a tracked board. If not, the phantom has the
  /// pose of its body in the scene.
  bool has_place() const { return pose || !board.empty(); }
};

struct ClientConfig {
  std::string tracker;  // address; empty: no tracker
  DeviceConfig tracker_device;
  std::array<StationRole, max_stations> stations{StationRole::right_hand};
  std::string tool;  // scene blade that the instrument represents in a session; empty: it only presses panels
  std::array<GloveSettings, 2> gloves;  // indexed by left_hand, right_hand; `device.glove.left` is set
  ArmSettings arm;
  Pose headset_room;  // pose of an OpenXR headset's stage in the room frame
  EyeSettings eyes;
  WindowSettings window;
  PhantomSettings phantom;
  std::map<Gesture, GestureEvent> gestures = {{Gesture::fist, GestureEvent::grasp},
                                              {Gesture::pinch, GestureEvent::grasp},
                                              {Gesture::flat, GestureEvent::release},
                                              {Gesture::index_little, GestureEvent::panel},
                                              {Gesture::three, GestureEvent::parts}};

  ClientConfig() {
    gloves[left_hand].device.glove.left = true;
    tracker_device.tags.boards[0] = "wrist-right";
  }
};

/// Reads the client's configuration file and checks the files that it references. Throws InputError with
/// file, line, key and the allowed values; unknown keys are errors.
ClientConfig load_client_config(const std::filesystem::path& file);
/// Parses the client's configuration from TOML text. `file` is the path that messages name; referenced files
/// are resolved relative to its folder.
ClientConfig parse_client_config(std::string_view toml, const std::string& file);

}  // namespace prosector
