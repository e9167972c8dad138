#include "twins/trackers/vrpn_tracker_twin.h"

#include <utility>

namespace prosector {
namespace {

constexpr std::int32_t control_number = 0, tracker_number = 1;                    // numbers of senders
constexpr std::int32_t pose_type_number = 0, analog_number = 1, pong_number = 2;  // numbers of message types
constexpr std::size_t version_at = 12;  // byte offset of the major version in the cookie

}  // namespace

void VrpnTrackerTwin::receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                              std::vector<TwinOutput>& out) {
  reader_.take(bytes);
  while (const auto message = reader_.next()) {
    if (reader_.type(*message) != vrpn::ping_type) continue;
    vrpn::put(out.emplace_back().bytes, {tracker_number, pong_number, {}});
  }
  if (!reader_.greeted() || std::exchange(named_, true)) return;
  vrpn::Bytes& greeting = out.emplace_back().bytes;
  greeting = vrpn::cookie();
  if (clock_.sends_wrong_version(now_ns)) greeting[version_at] = '8';
  vrpn::put(greeting, vrpn::naming(vrpn::names_sender, control_number, "VRPN Control"));
  vrpn::put(greeting, vrpn::naming(vrpn::names_sender, tracker_number, name_));
  vrpn::put(greeting, vrpn::naming(vrpn::names_type, pose_type_number, vrpn::pose_type));
  vrpn::put(greeting, vrpn::naming(vrpn::names_type, analog_number, vrpn::analog_type));
  vrpn::put(greeting, vrpn::naming(vrpn::names_type, pong_number, vrpn::pong_type));
}

void VrpnTrackerTwin::produce(std::int64_t now_ns, std::vector<TwinOutput>& out) {
  if (!named_ || !clock_.due(now_ns)) return;
  for (std::size_t station = 0; station < stations_; ++station) {
    const Pose pose = clock_.pose(station, now_ns);
    TwinOutput& record = out.emplace_back();
    vrpn::put(record.bytes,
              {tracker_number, pose_type_number,
               vrpn::body_of(vrpn::TrackerPose{static_cast<std::int32_t>(station), pose.p, pose.q})});
    record.is_record = true;
    record.station = static_cast<std::uint32_t>(station);
    record.record = records_[station]++;
    record.values = record_values(pose.p, pose.q);
  }
  const auto flexion = clock_.flexion(0, now_ns);
  vrpn::put(out.emplace_back().bytes,
            {tracker_number, analog_number, vrpn::body_of(vrpn::Channels(flexion.begin(), flexion.end()))});
}

void VrpnTrackerTwin::reset_client() {
  reader_ = {};
  named_ = false;
}

}  // namespace prosector
