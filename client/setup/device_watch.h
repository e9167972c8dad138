#pragma once
// The devices of a configuration, opened for inspection: their data, rates and motion.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/config/client_config.h"

namespace prosector {

/// Newest sample and statistics of one station (a tracker's receiver, a glove or an arm) over the last two
/// seconds.
struct WatchedStation {
  DeviceSample last;
  double rate = 0;    // Hz
  double moved = 0;   // m, extent of its motion
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
  /// Opens the tracker, gloves and arm of the configuration. The status of a device that isn't connected
  /// reports it, and opening it is retried. A device whose address or files are invalid is not retried.
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

/// Returns the number of the tracker's receiver that the user is moving: it moved at least
/// min_moved_distance, and at least least_share times as far as any other. Returns nullopt if there is none.
std::optional<std::uint32_t> moving_station(const WatchedDevice& tracker);

}  // namespace prosector
