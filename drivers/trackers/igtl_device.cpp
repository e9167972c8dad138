#include "drivers/trackers/igtl_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "drivers/device/plausible.h"
#include "drivers/device/station_sample.h"
#include "drivers/ports/stream_port.h"

namespace prosector {
namespace {

constexpr std::int32_t min_interval_ms = 5;  // minimum interval between two TDATA
constexpr std::int64_t unreadable_timeout_ns =
    5'000'000'000;  // without a readable message, while bytes arrive
constexpr const char* own_name = "Prosector";

}  // namespace

IgtlDevice::IgtlDevice(std::vector<std::string> names, std::unique_ptr<DevicePort> port,
                       const Placement& placement)
    : StreamDevice(std::move(port)),
      wanted_(std::move(names)),
      names_(wanted_),
      stations_(placement.stations),
      chain_(placement) {}

void IgtlDevice::started(std::int64_t) {
  reader_ = {};
  names_ = wanted_;
  igtl::Bytes out;
  igtl::put(out, {igtl::start_tools_type, own_name, igtl::start_body(min_interval_ms)});
  send({reinterpret_cast<const char*>(out.data()), out.size()});
}

void IgtlDevice::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  const bool received_bytes = !buffer().bytes().empty();
  reader_.take(buffer().bytes(), buffer().time_ns());
  buffer().clear();
  while (const auto message = reader_.next()) {
    if (take(*message, out))
      health().record(now_ns, message->body.size());
    else
      health().garbage(now_ns, message->body.size());
  }
  health().garbage(now_ns, reader_.consume_bad_byte_count());
  if (!reader_.problem().empty())
    refuse(reader_.problem());
  else if (received_bytes && health().quiet_ns(now_ns) > unreadable_timeout_ns)
    refuse("the server sends data, but neither TRANSFORM nor TDATA messages");
}

/// Processes a message. Returns whether it is plausible.
bool IgtlDevice::take(const igtl::Message& message, std::vector<DeviceSample>& out) {
  if (message.type == igtl::transform_type) {
    const auto tool = igtl::transform_of(message);
    return tool && take_tool(*tool, message.time_ns, out);
  }
  if (message.type != igtl::tools_type) return true;
  const auto tools = igtl::tools_of(message);
  if (!tools) return false;
  bool good = true;
  for (const igtl::Tool& tool : *tools) good = take_tool(tool, message.time_ns, out) && good;
  return good;
}

bool IgtlDevice::take_tool(const igtl::Tool& tool, std::int64_t time_ns, std::vector<DeviceSample>& out) {
  if (!is_rotation(tool.turn)) return false;
  const auto station = station_of(tool.name);
  if (!station) return true;
  auto sample = station_sample(chain_, *station, tool.place, Quat(tool.turn));
  if (!sample) return false;
  sample->record = records_[*station]++;
  sample->time_ns = time_ns;
  if ((stations_ >> *station & 1u) != 0) out.push_back(*sample);
  return true;
}

/// Returns the station of a name. If no names were requested, a new name gets the next free station.
std::optional<std::size_t> IgtlDevice::station_of(const std::string& name) {
  const auto found = std::ranges::find(names_, name);
  const auto station = static_cast<std::size_t>(found - names_.begin());
  if (found != names_.end()) return station;
  if (!wanted_.empty() || station == max_stations) return std::nullopt;
  names_.push_back(name);
  return station;
}

std::string IgtlDevice::silent_hint() const {
  return wanted_.empty()
             ? "the server is connected, but sends neither TRANSFORM nor TDATA messages"
             : fmt::format("the server is connected, but sends no data of the devices {}: check the names",
                           fmt::join(wanted_, ", "));
}

std::string IgtlDevice::babble_hint() const {
  return "the server's messages have wrong checksums, or matrices that are not rotations";
}

std::string IgtlDevice::absent_hint() const {
  return "check that the OpenIGTLink server runs and that its port can be reached";
}

std::unique_ptr<Device> open_igtl(const std::string& path, const Placement& placement) {
  const auto slash = path.find('/');
  const auto at = parse_host_port(path.substr(0, slash), igtl::default_port);
  std::vector<std::string> names;
  bool good = at.has_value();
  for (std::size_t from = slash; good && from != std::string::npos;) {
    const std::size_t to = path.find(',', from + 1);
    names.push_back(path.substr(from + 1, to == std::string::npos ? to : to - from - 1));
    good = !names.back().empty() && names.back().size() <= igtl::longest_name && names.size() <= max_stations;
    from = to;
  }
  if (!good)
    throw InputError(fmt::format(
        "device 'igtl:{}': must be igtl:HOST[:PORT][/NAME,NAME,...], as in igtl:lab:18944/Probe,Stylus, with "
        "at most {} names of {} bytes",
        path, max_stations, igtl::longest_name));
  const HostPort there = *at;
  auto port = std::make_unique<StreamPort>(there.host + ":" + there.port,
                                           [there] { return connect_tcp(there.host, there.port); });
  return std::make_unique<IgtlDevice>(std::move(names), std::move(port), placement);
}

}  // namespace prosector
