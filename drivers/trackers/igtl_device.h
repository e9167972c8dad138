#pragma once
// Tracker of an OpenIGTLink server, such as navigation software: TRANSFORM messages, which servers send
// unasked, and TDATA messages, which the driver requests.

#include <string>
#include <vector>

#include "drivers/device/pose_chain.h"
#include "drivers/device/stream_device.h"
#include "drivers/protocols/igtl_messages.h"

namespace prosector {

class IgtlDevice final : public StreamDevice {
 public:
  /// Takes the names of the OpenIGTLink server's tools or transforms; the first is station 1, and so on. If
  /// `names` is empty, names are assigned to stations in order of appearance. `port` connects to the server.
  IgtlDevice(std::vector<std::string> names, std::unique_ptr<DevicePort> port, const Placement& placement);

 private:
  void started(std::int64_t now_ns) override;
  void advance(std::int64_t) override {}
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;
  std::string absent_hint() const override;

  bool take(const igtl::Message& message, std::vector<DeviceSample>& out);
  bool take_tool(const igtl::Tool& tool, std::int64_t time_ns, std::vector<DeviceSample>& out);
  std::optional<std::size_t> station_of(const std::string& name);

  const std::vector<std::string> wanted_;
  std::vector<std::string> names_;  // names by station
  const std::uint32_t stations_;    // bit mask of active stations
  PoseChain chain_;
  igtl::Reader reader_;
  std::array<std::uint64_t, max_stations> records_{};
};

/// Creates the driver of an OpenIGTLink server's tracker. `path` is the address after "igtl:", such as
/// "lab:18944/Probe,Stylus". Throws InputError unless it is HOST[:PORT][/NAME,NAME,...].
std::unique_ptr<Device> open_igtl(const std::string& path, const Placement& placement);

}  // namespace prosector
