#pragma once
// The devices of a configuration, opened to be looked at: what each tells, how often, and what moves.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/client_config.h"

namespace prosector {

/// One station of a device, over the last two seconds.
struct WatchedStation {
  DeviceSample last;
  double rate = 0;    // Hz
  double moved = 0;   // m, from one end of its way to the other
  double bent = 0;    // flexion, the most that a finger changed
  double jitter = 0;  // s, RMS of the time between records
};

enum class WatchedKind : std::uint8_t { tracker, glove, arm };

struct WatchedDevice {
  WatchedKind kind = WatchedKind::tracker;
  std::size_t hand = right_hand;  // of a glove or an arm
  std::string name, address;      // "right glove", "5dt:/dev/ttyS1"
  DeviceStatus status;
  std::vector<WatchedStation> stations;  // by number; those that told something
};

class DeviceWatch {
 public:
  /// Opens what the configuration names. What can't be opened is retried, and its status says so; a file that
  /// can't be read isn't.
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

inline constexpr double least_way = 0.15;     // m: what moves that far is meant
inline constexpr double least_share = 3;      // times as far as any other
inline constexpr double least_bending = 0.4;  // flexion

/// Returns which station of a tracker is being moved: that which went far, and much farther than the others.
std::optional<std::uint32_t> moving_station(const WatchedDevice& tracker);
/// Tells whether a glove's fingers are being bent.
inline bool is_bent(const WatchedDevice& glove) {
  return !glove.stations.empty() && glove.stations.front().bent >= least_bending;
}

}  // namespace prosector
