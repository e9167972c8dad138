#pragma once
// A tracker behind OpenIGTLink, as navigation software speaks it: TRANSFORM that is sent unasked, and TDATA
// that is asked for.

#include <string>
#include <vector>

#include "drivers/igtl_messages.h"
#include "drivers/pose_chain.h"
#include "drivers/stream_device.h"

namespace prosector {

class IgtlDevice final : public StreamDevice {
 public:
  /// Takes names of tools, or of transforms, in the order of stations; none: stations go to names as these
  /// appear.
  IgtlDevice(std::vector<std::string> names, std::unique_ptr<DevicePort> port, const DeviceConfig& config);

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
  std::vector<std::string> names_;  // of stations
  DeviceConfig config_;
  PoseChain chain_;
  igtl::Reader reader_;
  std::array<std::uint64_t, max_stations> records_{};
};

/// Opens a tracker at a server, "igtl:lab:18944/Probe,Stylus". Throws InputError for what is no
/// HOST[:PORT][/NAME,NAME,...].
std::unique_ptr<Device> open_igtl(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
