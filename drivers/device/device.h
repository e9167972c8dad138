#pragma once
// Interface of an input device for the client. poll() never blocks; the driver reconnects automatically.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/hand_pose.h"
#include "common/math.h"

namespace prosector {

enum class DeviceHealth : std::uint8_t {
  connecting,  // opened, no valid record yet
  streaming,   // valid records arrive
  silent,      // open, but no valid record for a while; the driver reopens or resets it
  babbling,    // bytes arrive, but most are not valid records
  absent,      // cannot be opened; the driver retries
};
/// Returns the name of an input device's health state, such as "streaming", for messages to the user.
inline const char* health_name(DeviceHealth health) {
  constexpr std::array words = {"connecting", "streaming", "silent", "babbling", "absent"};
  return words[static_cast<std::size_t>(health)];
}

inline constexpr std::int32_t max_sample_buttons = 32;  // bits in a sample's button mask

/// One reading of one station (a tracker's receiver or a glove). The members `has_pose` and `has_flexion`
/// mark which other members are valid.
struct DeviceSample {
  std::uint32_t station = 0;  // tracker: 0-based receiver; glove: 0
  std::uint64_t record = 0;   // counts valid records of this station since the device was opened
  std::int64_t time_ns = 0;   // monotonic_ns() when the first byte of the record was read
  bool has_pose = false;
  Pose pose;                        // room frame, after alignment; m
  std::array<float, 7> raw_pose{};  // as the device sent it: x y z q0 q1 q2 q3 (or azimuth, elevation, roll,
                                    // 0), in its own units and frame
  bool has_flexion = false;
  std::array<double, fingers> flexion{};  // calibrated, 0 open … 1 closed
  std::array<std::uint16_t, fingers> raw_flexion{};
  Gesture gesture = Gesture::none;
  std::uint32_t buttons = 0;
  char error = ' ';  // the device's own error character; ' ': no error

  /// Returns whether the sample has a pose and the device reported no error with it.
  bool has_trusted_pose() const { return has_pose && error == ' '; }
};

struct DeviceStatus {
  DeviceHealth health = DeviceHealth::connecting;
  std::uint64_t records = 0;  // valid records
  std::uint64_t resyncs = 0;  // number of times that garbage was skipped
  std::uint64_t skipped_bytes = 0;
  std::uint64_t reopens = 0;
  std::string message;  // for the user: the problem and its remedy
};

class Device {
 public:
  virtual ~Device() = default;
  /// Reads the data received from the device without blocking and appends the resulting samples to `out` in
  /// order of arrival. Reopens a lost device when a retry is due.
  virtual void poll(std::vector<DeviceSample>& out) = 0;
  virtual DeviceStatus status() const = 0;
  /// Returns a file descriptor that becomes readable when poll() has data to read, or −1 if there is none.
  virtual int descriptor() const = 0;
};

/// Driver name and path of a device's address, which is written DRIVER:PATH, such as "fastrak:/dev/ttyS0",
/// "5dt:/dev/ttyS1", "5dt-usb:/dev/hidraw0" or "recorded:hand.csv".
struct DeviceAddress {
  std::string driver;
  std::string path;
};

inline constexpr std::size_t max_stations = 4;  // receivers per tracker

}  // namespace prosector
