// VRPN server: each object is a tracker with one sensor.
#include <map>
#include <set>
#include <utility>

#include "client/offer/offer_protocol.h"
#include "drivers/protocols/vrpn_messages.h"

namespace prosector {
namespace {

constexpr std::int32_t pose_number = 0, pong_number = 1;  // message type ids
constexpr std::int32_t control_number = 0;                // sender ids; objects have the following ones
constexpr std::size_t most_senders = 1000;                // number of distinct senders that a peer may ping

class VrpnTalk final : public OfferConnection {
 public:
  bool hear(std::span<const std::uint8_t> bytes) override {
    reader_.take(bytes);
    while (const auto message = reader_.next())
      if (reader_.type(*message) == vrpn::ping_type && !reader_.sender(*message).empty())
        pinged_.insert(reader_.sender(*message));
    return !reader_.broken() && pinged_.size() <= most_senders;
  }

  Bytes say(const std::vector<Offered>& things, std::int64_t now_ns) override {
    Bytes out;
    if (!std::exchange(greeted_, true)) {
      out = vrpn::cookie();
      vrpn::put(out, vrpn::naming(vrpn::names_sender, control_number, "VRPN Control"));
      vrpn::put(out, vrpn::naming(vrpn::names_type, pose_number, vrpn::pose_type));
      vrpn::put(out, vrpn::naming(vrpn::names_type, pong_number, vrpn::pong_type));
    }
    if (!reader_.greeted()) return out;
    for (const Offered& thing : things)
      vrpn::put(out, {number_of(thing.name, out), pose_number,
                      vrpn::body_of(vrpn::TrackerPose{0, thing.pose.p, thing.pose.q}), now_ns});
    for (const std::string& name : std::exchange(pinged_, {}))
      if (numbers_.contains(name)) vrpn::put(out, {numbers_[name], pong_number, {}, now_ns});
    return out;
  }

 private:
  vrpn::Reader reader_;
  bool greeted_ = false;
  std::map<std::string, std::int32_t> numbers_;
  std::set<std::string> pinged_;

  /// Returns an object's sender id. Before its first use, its name is sent.
  std::int32_t number_of(const std::string& name, Bytes& out) {
    const auto [entry, is_new] = numbers_.emplace(name, static_cast<std::int32_t>(numbers_.size()) + 1);
    if (is_new) vrpn::put(out, vrpn::naming(vrpn::names_sender, entry->second, name));
    return entry->second;
  }
};

}  // namespace

std::unique_ptr<OfferConnection> make_vrpn_connection() {
  return std::make_unique<VrpnTalk>();
}

}  // namespace prosector
