#pragma once
// A tracker, its buttons and a glove's analog or dials at a VRPN server, of one name there.

#include <string>

#include "drivers/glove_hand.h"
#include "drivers/pose_chain.h"
#include "drivers/stream_device.h"
#include "drivers/vrpn_messages.h"

namespace prosector {

class VrpnDevice final : public StreamDevice {
 public:
  /// Takes the device's name at its server, and what leads there.
  VrpnDevice(std::string name, std::unique_ptr<DevicePort> port, const DeviceConfig& config);

 private:
  void started(std::int64_t now_ns) override;
  void advance(std::int64_t now_ns) override;
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;
  std::string absent_hint() const override;

  /// Takes a message of the device's. Returns whether it can be one.
  bool take(const vrpn::Message& message, std::vector<DeviceSample>& out);
  bool take_pose(const vrpn::Message& message, std::vector<DeviceSample>& out);
  bool take_bends(std::int64_t time_ns, std::vector<DeviceSample>& out);

  std::string name_;
  DeviceConfig config_;
  PoseChain chain_;
  GloveHand hand_;
  vrpn::Reader reader_;
  std::int64_t pinged_ns_ = 0;
  std::array<std::uint64_t, max_stations> records_{};
  std::uint32_t buttons_ = 0;
  std::array<double, fingers> channels_{};  // of the analog, or what dials were turned by in sum
};

/// Opens a device at a server, "vrpn:Tracker0@lab:3883". Throws InputError for what is no NAME@HOST[:PORT].
std::unique_ptr<Device> open_vrpn_device(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
