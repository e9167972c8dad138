#include "twins/arms/vrpn_twin.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr std::int64_t servo_ns = 1'000'000;  // servo period
constexpr std::int64_t max_lag_ns = 50 * servo_ns;
constexpr std::int32_t arm_sender = 3, pose_number = 5, button_number = 6, error_number = 7;

}  // namespace

VrpnTwin::VrpnTwin(VrpnTwinOptions options, std::int64_t now_ns)
    : garbage(options.garbage),
      name_(options.name),
      arm_(std::move(static_cast<HeldArmOptions&>(options)), ArmMechanics{}, now_ns),
      random_(options.seed),
      now_ns_(now_ns) {}

void VrpnTwin::receive(std::span<const std::uint8_t> bytes) {
  reader_.take(bytes);
  while (const auto message = reader_.next()) {
    if (message->type < 0) continue;
    const auto field = reader_.type(*message) == vrpn::field_type && reader_.sender(*message) == name_
                           ? vrpn::field_of(message->body)
                           : std::nullopt;
    const bool good = field && field->origin.allFinite() && field->force.allFinite() &&
                      field->jacobian.allFinite() && field->radius >= 0;
    if (good)
      field_ = *field;
    else
      ++bad_messages_;
  }
}

vrpn::Bytes VrpnTwin::advance(std::int64_t now_ns) {
  now_ns_ = std::max(now_ns_, now_ns - max_lag_ns);
  while (now_ns_ < now_ns) {
    now_ns_ = std::min(now_ns_ + servo_ns, now_ns);
    const Vec3 way = field_ ? Vec3(arm_.model().position() - field_->origin) : Vec3(Vec3::Zero());
    arm_.set_force(field_ && way.norm() <= field_->radius ? Vec3(field_->force + field_->jacobian * way)
                                                          : Vec3(Vec3::Zero()));
    arm_.advance(now_ns_);
  }
  vrpn::Bytes out;
  if (!reader_.greeted()) return out;
  if (!std::exchange(named_, true)) {
    greet(out);
    arm_.take(now_ns_);
  }
  vrpn::put(out, {arm_sender, pose_number,
                  vrpn::body_of(vrpn::TrackerPose{0, arm_.model().measured(), arm_.orientation()})});
  if (std::uniform_real_distribution<double>(0, 1)(random_) < garbage)
    for (std::size_t i = out.size() - 56; i < out.size(); ++i) out[i] = static_cast<std::uint8_t>(random_());
  if (const auto pressed = std::exchange(button_, std::nullopt))
    vrpn::put(out, {arm_sender, button_number, vrpn::body_of(vrpn::Button{0, *pressed})});
  if (const auto code = std::exchange(queued_error_code_, std::nullopt))
    vrpn::put(out, {arm_sender, error_number, vrpn::body_of(*code)});
  return out;
}

/// Answers a client's cookie.
void VrpnTwin::greet(vrpn::Bytes& out) const {
  out = vrpn::cookie();
  vrpn::put(out, vrpn::naming(vrpn::names_sender, 0, "VRPN Control"));
  vrpn::put(out, vrpn::naming(vrpn::names_sender, arm_sender, name_));
  vrpn::put(out, vrpn::naming(vrpn::names_type, pose_number, vrpn::pose_type));
  vrpn::put(out, vrpn::naming(vrpn::names_type, button_number, vrpn::button_type));
  vrpn::put(out, vrpn::naming(vrpn::names_type, error_number, vrpn::error_type));
}

void VrpnTwin::hang_up() {
  reader_ = {};
  named_ = false;
  field_.reset();
  arm_.put_down();
}

}  // namespace prosector
