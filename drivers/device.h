#pragma once
// A device as the client sees it: poll it, it never blocks, it heals by itself.

#include <array>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "common/eye_distance.h"
#include "common/math.h"
#include "common/messages.h"
#include "drivers/camera/hands/hand_nets.h"

namespace prosector {

enum class DeviceHealth : std::uint8_t {
  connecting,  // opened, no valid record yet
  streaming,   // valid records arrive
  silent,      // open but nothing valid for a while; the driver is reopening or resetting it
  babbling,    // bytes arrive but most are no records
  absent,      // cannot be opened; retried
};
/// Returns what people read of it.
inline const char* health_word(DeviceHealth health) {
  constexpr std::array words = {"connecting", "streaming", "silent", "babbling", "absent"};
  return words[static_cast<std::size_t>(health)];
}

inline constexpr std::int32_t buttons_told = 32;  // bits of a sample's buttons

/// One reading of one station (a tracker's receiver, a glove). Flags say which fields hold something.
struct DeviceSample {
  std::uint32_t station = 0;  // tracker: 0-based receiver; glove: 0
  std::uint64_t record = 0;   // counts valid records of this station since the device was opened
  std::int64_t time_ns = 0;   // monotonic_ns() when the first byte of the record was read
  bool has_pose = false;
  Pose pose;  // in the room, after alignment; metres
  std::array<float, 7>
      raw_pose{};  // as the device sent it: x y z q0 q1 q2 q3 (or az el roll 0), its own units and frame
  bool has_flexion = false;
  std::array<double, fingers> flexion{};  // calibrated, 0 open … 1 closed
  std::array<std::uint16_t, fingers> raw_flexion{};
  Gesture gesture = Gesture::none;
  std::uint32_t buttons = 0;
  char error = ' ';  // the device's own error character, ' ' is well

  /// Returns whether the pose is one that the device itself trusts.
  bool has_trusted_pose() const { return has_pose && error == ' '; }
};

struct DeviceStatus {
  DeviceHealth health = DeviceHealth::connecting;
  std::uint64_t records = 0;  // valid
  std::uint64_t resyncs = 0;  // times garbage was skipped
  std::uint64_t skipped_bytes = 0;
  std::uint64_t reopens = 0;
  std::string message;  // for people: what is wrong and what to do
};

class Device {
 public:
  virtual ~Device() = default;
  /// Reads what arrived, never blocks; appends samples in order. Reopens a lost device on its own schedule.
  virtual void poll(std::vector<DeviceSample>& out) = 0;
  virtual DeviceStatus status() const = 0;
  /// Returns a descriptor that becomes readable when poll() has work, or −1.
  virtual int descriptor() const = 0;
};

/// The driver, then what it opens: "fastrak:/dev/ttyS0", "5dt:/dev/ttyS1", "5dt-usb:/dev/hidraw0",
/// "recorded:hand.csv".
struct DeviceAddress {
  std::string driver;
  std::string path;
};

class SharedCamera;

/// One row of the table of drivers.
struct DriverRow {
  const char* name;
  const char* help;  // one line for --help
  std::unique_ptr<Device> (*open)(const std::string& path, const struct DeviceConfig& config);
  bool knows_hands = false;  // station 1 is the right hand, station 2 the left one, whatever is configured
  bool is_camera = false;    // `path` is a camera's address, or those of several with commas
  bool knows_head = false;   // station 1 is the head, whatever is configured
};

inline constexpr std::size_t max_stations = 4;  // receivers of one tracker

/// A board that lies flat, as high as the tables of scenes; its upper side is the far one.
inline const Pose on_scenes_table = {{0, 0.9, 0},
                                     Quat(std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2, 0, 0)};

/// What a glove's raw counts mean; without one the driver learns each sensor's range from what it sees.
struct GloveCalibration {
  std::array<double, fingers> open{},
      closed{};  // counts; open may be the larger where counts fall on bending
};

/// How a device stands in the room and what its gestures mean. Loaded from the client's configuration.
struct DeviceConfig {
  Pose room_device;    // pose of the device's frame (tracker: x right, y up, −z forward) in the room
  bool binary = true;  // fastrak: binary records
  std::uint32_t stations = 1;  // fastrak: bit mask of active stations
  std::array<Pose, max_stations>
      mount;                    // fastrak: pose of the tracked thing (wrist, eyes) in its receiver's frame
  Vec3 hemisphere = {1, 0, 0};  // fastrak: zenith of the operational hemisphere, transmitter frame
  bool boresight = false;       // fastrak: boresight every station when it starts
  std::optional<std::array<double, 9>> alignment;  // fastrak: O, X, Y points of the alignment frame, cm
  std::string field_map;    // fastrak: file that puts poses right where metal bends the field; empty: none
  std::string lens;         // camera: file of its calibration; empty: guessed
  std::string second_lens;  // bare hands: that of a second camera
  Pose first_second;        // bare hands: a second camera's pose in the first one's frame
  std::optional<double> hand_length;  // bare hands: m, wrist to the middle finger's tip; unknown: our hand's
  HandNets hand_nets = HandNets::full;       // bare hands
  double farthest_hand = usual_hand_range;   // bare hands: m; those beyond it are bystanders'
  double eye_distance = usual_eye_distance;  // face: m, between the user's pupils; depth errs as it does
  std::array<std::string, max_stations>
      boards{};       // camera: each station's, a known board's name or a file; empty: none
  std::string table;  // camera: the board that lies still and says where the room is; empty: none
  Pose room_table = on_scenes_table;              // its pose in the room
  std::shared_ptr<SharedCamera> camera = {};      // that others see by, too; null: the device opens its own
  bool left = false;                              // glove: left hand
  double closed_above = 0.65, open_below = 0.35;  // glove: gesture thresholds, flexion
  double hysteresis = 0.05;       // glove: how far past its threshold a finger keeps its state
  bool pinch = false;             // glove: index closed, thumb bent, the others open, is a pinch
  bool falls_on_bending = false;  // glove: counts fall when a finger bends (some USB gloves)
  std::optional<GloveCalibration> calibration;  // glove: fixed counts instead of learning them
};

const std::vector<DriverRow>& drivers();

/// Splits an address. Throws InputError for an unknown driver (listing the known ones) or a missing path.
DeviceAddress parse_device_address(const std::string& address);

/// Returns the row of an address' driver. Throws InputError for an unknown one (listing the known ones).
const DriverRow& driver_of(const std::string& address);

/// Returns the camera of a device's address, the first one of several; empty: it has none.
std::string first_camera(const std::string& address);

/// Opens a device by address. Throws InputError for an unknown driver (listing the known ones).
std::unique_ptr<Device> open_device(const std::string& address, const DeviceConfig& config);

}  // namespace prosector
