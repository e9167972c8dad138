#include "drivers/arms/vrpn_arm.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "drivers/arms/omni.h"
#include "drivers/device/plausible.h"

namespace prosector {
namespace {

constexpr std::int64_t pose_timeout_ns = 100'000'000;  // expiry of a pose; some servers report at only 60 Hz
constexpr std::int64_t server_timeout_ns = 3'000'000'000;
constexpr std::int64_t hot_duration_ns =
    5'000'000'000;                     // duration for which motors count as hot after an error
constexpr double field_radius = 5e-3;  // m: allowed hand motion until the next field update; beyond it no
                                       // force acts
constexpr std::int32_t own_sender = 0, own_field = 0;  // numbers announced to the server
constexpr std::int32_t buttons_known = 32;

}  // namespace

VrpnArm::VrpnArm(std::string name, const ArmConfig& config,
                 std::function<std::unique_ptr<ByteStream>()> connect, std::launch opening,
                 std::function<std::int64_t()> clock)
    : name_(std::move(name)),
      config_(config),
      limits_(omni_limits()),  // a VRPN server does not report the type of its arm
      clock_(std::move(clock)),
      opening_(std::move(connect), opening) {}

VrpnArm::~VrpnArm() {
  if (opening_.get() != nullptr) VrpnArm::set_field(Vec3::Zero(), Mat3::Zero());
}

ArmReading VrpnArm::read() {
  const std::int64_t now = clock_();
  ByteStream* line = opening_.poll(now);
  if (line == nullptr) return {};
  if (!std::exchange(greeted_, true)) greet(*line);
  bytes_.clear();
  const bool there = line->receive(bytes_);
  reader_.take(bytes_);
  while (const auto message = reader_.next()) take(*message, now);
  if (!there) {
    lose(line->error(), now);
  } else if (reader_.broken()) {
    ++counts_.resyncs;
    lose("the server does not use VRPN 07, the only supported version", now);
  } else if (now - std::max(heard_ns_, opening_.opened_ns()) > server_timeout_ns) {
    lose("the VRPN server no longer sends data", now);
  }
  ArmReading out = last_;
  out.valid = last_pose_ns_ > 0 && now - last_pose_ns_ <= pose_timeout_ns;
  out.hot = now < hot_until_ns_;
  out.stylus = config_.room_arm * out.stylus;
  return out;
}

/// Starts the conversation: sends the cookie and announces the driver's sender and message type.
void VrpnArm::greet(ByteStream& line) {
  reader_ = {};
  vrpn::Bytes out = vrpn::cookie();
  vrpn::put(out, vrpn::naming(vrpn::names_sender, own_sender, name_));
  vrpn::put(out, vrpn::naming(vrpn::names_type, own_field, vrpn::field_type));
  line.send(out);
}

void VrpnArm::take(const vrpn::Message& message, std::int64_t now_ns) {
  heard_ns_ = now_ns;
  if (message.type < 0 || reader_.sender(message) != name_) return;
  const std::string& type = reader_.type(message);
  if (type == vrpn::pose_type) {
    const auto said = vrpn::tracker_pose_of(message.body);
    if (said && said->sensor != 0) return;
    const auto pose = said ? plausible_pose(said->place, said->turn, arm_reach) : std::nullopt;
    ++(pose ? counts_.records : counts_.resyncs);
    last_pose_ns_ = pose ? now_ns : 0;
    if (pose) last_.stylus = *pose;
  } else if (type == vrpn::button_type) {
    const auto button = vrpn::button_of(message.body);
    if (!button || button->number < 0 || button->number >= buttons_known) return;
    const std::uint32_t bit = 1u << button->number;
    last_.buttons = button->pressed ? last_.buttons | bit : last_.buttons & ~bit;
  } else if (type == vrpn::error_type) {
    const auto code = vrpn::code_of(message.body);
    if (code == vrpn::duty_cycle_error) hot_until_ns_ = now_ns + hot_duration_ns;
    if (code == vrpn::no_force_error) hot_until_ns_ = 0;
  }
}

void VrpnArm::lose(std::string why, std::int64_t now_ns) {
  opening_.lose(std::move(why), now_ns);
  greeted_ = false;
  last_pose_ns_ = 0;
  last_ = {};
  ++counts_.reopens;
}

void VrpnArm::set_field(const Vec3& force, const Mat3& stiffness) {
  ByteStream* line = opening_.get();
  if (line == nullptr || !greeted_ || !force.allFinite() || !stiffness.allFinite()) return;
  const Mat3 turn = config_.room_arm.q.toRotationMatrix();
  vrpn::ForceField field;
  field.origin = last_.stylus.p;
  field.force = turn.transpose() * bounded_force(force, limits_.peak_force);
  field.jacobian = -(turn.transpose() * stiffness * turn);
  field.radius = field_radius;
  vrpn::Bytes out;
  vrpn::put(out, {own_sender, own_field, vrpn::body_of(field)});
  line->send(out);
}

DeviceStatus VrpnArm::status() const {
  DeviceStatus out = counts_;
  const bool open = opening_.get() != nullptr;
  if (!open) {
    out.health = opening_.problem().empty() ? DeviceHealth::connecting : DeviceHealth::absent;
    out.message = opening_.problem();
  } else if (last_pose_ns_ > 0 && clock_() - last_pose_ns_ <= pose_timeout_ns) {
    out.health = DeviceHealth::streaming;
    if (clock_() < hot_until_ns_)
      out.message = "the arm's motors are hot: force is reduced until they have cooled down";
  } else {
    out.health = DeviceHealth::silent;
    out.message =
        fmt::format("the server is connected, but sends no pose of '{}': check the arm's name", name_);
  }
  return out;
}

std::unique_ptr<Arm> open_vrpn(const std::string& path, const ArmConfig& config) {
  const auto there = vrpn::parse_device_location(path);
  if (!there)
    throw InputError(
        fmt::format("arm 'vrpn:{}': must be vrpn:NAME@HOST[:PORT], as in vrpn:Phantom0@lab", path));
  return std::make_unique<VrpnArm>(there->name, config,
                                   [there] { return connect_tcp(there->at.host, there->at.port); });
}

}  // namespace prosector
