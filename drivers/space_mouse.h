#pragma once
// A SpaceMouse by spacenavd's socket. Its cap comes back to the middle by itself, so that it moves a hand by
// speed: the farther it is pushed, the faster.

#include <string>

#include "drivers/space_mouse_records.h"
#include "drivers/stream_device.h"

namespace prosector {

class SpaceMouse final : public StreamDevice {
 public:
  SpaceMouse(std::unique_ptr<DevicePort> port, const DeviceConfig& config);
  DeviceStatus status() const override;

 private:
  void started(std::int64_t now_ns) override;
  void advance(std::int64_t) override {}
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;
  std::string absent_hint() const override;

  void take(const space_mouse::Record& record, std::int64_t now_ns);
  void move(double seconds);

  DeviceConfig config_;
  Pose hand_;  // in the frame of [tracker.room]
  std::array<std::int32_t, space_mouse::axes> push_{};
  std::int64_t pushed_ns_ = 0, moved_ns_ = 0;
  std::uint32_t buttons_ = 0;
  std::uint64_t records_ = 0;
};

/// Opens a SpaceMouse, "spacemouse:/run/spnav.sock".
std::unique_ptr<Device> open_space_mouse(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
