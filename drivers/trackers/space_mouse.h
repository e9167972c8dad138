#pragma once
// SpaceMouse through spacenavd's socket. Its cap returns to the middle when released, so its deflection sets
// the velocity of a hand.

#include <string>

#include "drivers/device/placement.h"
#include "drivers/device/stream_device.h"
#include "drivers/protocols/space_mouse_records.h"

namespace prosector {

class SpaceMouse final : public StreamDevice {
 public:
  SpaceMouse(std::unique_ptr<DevicePort> port, const Placement& placement);
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

  Placement placement_;
  Pose hand_;  // pose of the hand in the frame of [tracker.room]
  std::array<std::int32_t, space_mouse::axes> push_{};
  std::int64_t pushed_ns_ = 0, moved_ns_ = 0;
  std::uint32_t buttons_ = 0;
  std::uint64_t records_ = 0;
};

/// Creates the driver of a SpaceMouse. `path` is the socket of the daemon spacenavd, such as
/// "/run/spnav.sock" in the address "spacemouse:/run/spnav.sock".
std::unique_ptr<Device> open_space_mouse(const std::string& path, const Placement& placement);

}  // namespace prosector
