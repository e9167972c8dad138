#include "twins/trackers/igtl_twin.h"

namespace prosector {
namespace {

constexpr std::uint16_t right_version = 1, another_version = 9;
constexpr const char* own_device = "Tracker";

}  // namespace

void IgtlTwin::receive(std::span<const std::uint8_t> bytes, std::int64_t, std::vector<TwinOutput>& out) {
  reader_.take(bytes);
  while (const auto message = reader_.next()) {
    if (message->type == igtl::stop_tools_type) tools_ = false;
    if (message->type != igtl::start_tools_type || !igtl::interval_of(*message)) continue;
    tools_ = true;
    igtl::put(out.emplace_back().bytes, {igtl::started_tools_type, own_device, igtl::started_body()});
  }
}

igtl::Tool IgtlTwin::tool(std::size_t station, std::int64_t now_ns) const {
  const Pose pose = clock_.pose(station, now_ns);
  return {"Tool" + std::to_string(station + 1), pose.p, pose.q.toRotationMatrix()};
}

void IgtlTwin::put(const igtl::Message& message, std::size_t station, const igtl::Tool& tool,
                   std::int64_t now_ns, std::vector<TwinOutput>& out) {
  TwinOutput& record = out.emplace_back();
  igtl::put(record.bytes, message, clock_.sends_wrong_version(now_ns) ? another_version : right_version);
  if (std::bernoulli_distribution(bad_checksum_fraction_)(random_)) record.bytes.back() ^= 1u;
  record.is_record = true;
  record.station = static_cast<std::uint32_t>(station);
  record.record = records_[station]++;
  record.values = record_values(tool.place, Quat(tool.turn));
}

void IgtlTwin::produce(std::int64_t now_ns, std::vector<TwinOutput>& out) {
  if (!clock_.due(now_ns)) return;
  const igtl::Tool first = tool(0, now_ns);
  put({igtl::transform_type, first.name, igtl::transform_body(first)}, 0, first, now_ns, out);
  if (!tools_ || stations_ == 1) return;
  std::vector<igtl::Tool> others;
  for (std::size_t station = 1; station < stations_; ++station) others.push_back(tool(station, now_ns));
  put({igtl::tools_type, own_device, igtl::tools_body(others)}, 1, others.front(), now_ns, out);
}

void IgtlTwin::reset_client() {
  reader_ = {};
  tools_ = false;
}

}  // namespace prosector
