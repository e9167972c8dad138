#pragma once
// The devices of a configuration, opened for inspection: their data, rates and motion.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/config/client_config.h"

namespace prosector {

/// One station of a device, over the last two seconds.
struct WatchedStation {
  DeviceSample last;
  double rate = 0;    // Hz
  double moved = 0;   // m, extent of its motion
  double bent = 0;    // flexion, the largest change of any finger
  double jitter = 0;  // s, RMS of the deviation of intervals between records
};

enum class WatchedKind : std::uint8_t { tracker, glove, arm };

struct WatchedDevice {
  WatchedKind kind = WatchedKind::tracker;
  std::size_t hand = right_hand;  // for a glove or an arm
  std::string name, address;      // "right glove", "5dt:/dev/ttyS1"
  DeviceStatus status;
  std::vector<WatchedStation> stations;  // by number; those with data
};

class DeviceWatch {
 public:
  /// Opens the devices of the configuration. Devices that can't be opened are retried, and their status
  /// reports it; a file that can't be read is not retried.
  explicit DeviceWatch(const ClientConfig& config);
  ~DeviceWatch();

  void poll(std::int64_t now_ns);
  const std::vector<WatchedDevice>& devices() const { return devices_; }

 private:
  struct Opened;
  std::vector<std::unique_ptr<Opened>> opened_;
  std::vector<WatchedDevice> devices_;  // in the same order

  void add(WatchedDevice device, std::unique_ptr<Opened> opened);
};

inline constexpr double min_moved_distance = 0.15;  // m: minimum intended motion
inline constexpr double least_share = 3;            // minimum ratio to the motion of any other
inline constexpr double min_flexion_change = 0.4;   // flexion

/// Returns the station of a tracker that is being moved: the one that moved far, and much farther than the
/// others.
std::optional<std::uint32_t> moving_station(const WatchedDevice& tracker);
/// Returns whether a glove's fingers are being bent.
inline bool is_bent(const WatchedDevice& glove) {
  return !glove.stations.empty() && glove.stations.front().bent >= min_flexion_change;
}

}  // namespace prosector
