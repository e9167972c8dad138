#pragma once
// Tracker of a VRPN server, with buttons and the analog or dials of a glove, all with one name.

#include <string>

#include "drivers/device/pose_chain.h"
#include "drivers/device/stream_device.h"
#include "drivers/gloves/glove_hand.h"
#include "drivers/protocols/vrpn_messages.h"

namespace prosector {

class VrpnDevice final : public StreamDevice {
 public:
  /// Takes the tracker's name on the VRPN server and the port that connects to this server.
  VrpnDevice(std::string name, std::unique_ptr<DevicePort> port, const Placement& placement,
             const GestureThresholds& gestures, const GloveConfig& glove);

 private:
  void started(std::int64_t now_ns) override;
  void advance(std::int64_t now_ns) override;
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;
  std::string absent_hint() const override;

  /// Processes a message that the VRPN server sent about this device, and appends the resulting samples.
  /// Returns whether the message is plausible.
  bool take(const vrpn::Message& message, std::vector<DeviceSample>& out);
  bool take_pose(const vrpn::Message& message, std::vector<DeviceSample>& out);
  bool take_bends(std::int64_t time_ns, std::vector<DeviceSample>& out);

  std::string name_;
  const std::uint32_t stations_;  // bit mask of active stations
  const bool is_calibrated_;      // channels are scaled to flexions
  PoseChain chain_;
  GloveHand hand_;
  vrpn::Reader reader_;
  std::int64_t last_ping_ns_ = 0;
  std::array<std::uint64_t, max_stations> records_{};
  std::uint32_t buttons_ = 0;
  std::array<double, fingers> channels_{};  // analog channels, or accumulated rotation of the dials
};

/// Creates the driver of a VRPN server's tracker. `path` is the address after "vrpn:", such as
/// "Tracker0@lab:3883". Throws InputError unless it is NAME@HOST[:PORT].
std::unique_ptr<Device> open_vrpn_device(const std::string& path, const Placement& placement,
                                         const GestureThresholds& gestures, const GloveConfig& glove);

}  // namespace prosector
