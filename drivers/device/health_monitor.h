#pragma once
// Derives a device's health (absent, silent, babbling, …) from its recent data.

#include <cstdint>

#include "drivers/device/device.h"

namespace prosector {

inline constexpr std::int64_t silence_limit_ns = 1'000'000'000;  // time without a valid record after which a
                                                                 // device is silent

class HealthMonitor {
 public:
  void opened(std::int64_t now_ns);
  void lost();
  void record(std::int64_t now_ns, std::size_t bytes);
  /// Counts `bytes` of received data that the driver skipped because they belong to no valid record. Call it
  /// once per contiguous run of such bytes, since each call counts as one resynchronisation.
  void garbage(std::int64_t now_ns, std::size_t bytes);

  DeviceHealth health(std::int64_t now_ns) const;
  /// Returns the device's health at `now_ns` and its counts of records, resynchronisations (skipped runs of
  /// garbage), skipped bytes and reopens. The message is empty.
  DeviceStatus status(std::int64_t now_ns) const;
  /// Returns the time in ns from the device's last valid record until `now_ns`. Counts from the opening of
  /// the device if no record has arrived since.
  std::int64_t quiet_ns(std::int64_t now_ns) const { return now_ns - last_ns_; }
  std::uint64_t records() const { return records_; }
  std::uint64_t resyncs() const { return resyncs_; }
  std::uint64_t skipped_bytes() const { return skipped_bytes_; }
  std::uint64_t reopens() const { return opens_ > 0 ? opens_ - 1 : 0; }

 private:
  void roll_window(std::int64_t now_ns);

  bool open_ = false;
  bool streamed_ = false;  // since it was opened
  std::int64_t opened_ns_ = 0, last_ns_ = 0, last_garbage_ns_ = 0, window_ns_ = 0;
  std::uint64_t records_ = 0, resyncs_ = 0, skipped_bytes_ = 0, opens_ = 0;
  struct Window {
    std::uint64_t valid = 0, garbage = 0;  // bytes
  };
  Window now_, before_;  // the current and the previous window of 0.5 s
};

}  // namespace prosector
