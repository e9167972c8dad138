#include "client/app/user/arm_hand.h"

#include <fmt/format.h>

#include <utility>

#include "common/index_tip.h"

namespace prosector {
namespace {

constexpr std::uint32_t first_button = 1;
constexpr std::array<double, fingers> pointing = {1, 0, 1, 1, 1};  // flexion: the index finger is the tip

/// Returns the wrist's pose in the stylus frame.
Pose mount_of(const ArmSettings& settings) {
  if (settings.mount) return *settings.mount;
  HandPose hand;
  hand.flexion = pointing;
  return {-index_tip(settings.hand, hand), Quat::Identity()};
}

/// Returns the bit mask of a button, numbered from 1; 0 for button 0 (no button).
std::uint32_t bit_of(unsigned button) {
  return button == 0 ? 0 : 1u << (button - 1);
}

const char* words_of(DeviceHealth health) {
  switch (health) {
    case DeviceHealth::connecting:
      return "connecting";
    case DeviceHealth::streaming:
      return "ready";
    case DeviceHealth::silent:
      return "silent";
    case DeviceHealth::babbling:
      return "sends invalid packets";
    case DeviceHealth::absent:
      return "away";
  }
  return "";
}

}  // namespace

ArmHand::ArmHand(const ArmSettings& settings)
    : settings_(settings),
      servo_(open_arm(settings.address, settings.arm), mount_of(settings), bit_of(settings.dead_man)) {}

void ArmHand::received(const FeltPlanes& felt, ParticipantId participant) {
  if (felt.participant != participant || felt.hand != settings_.hand) return;
  if (felt_tick_.exchange(felt.time.tick) == felt.time.tick) {
    servo_.repeat_received();
  } else {
    servo_.feel(felt.planes);
    far_taken_ = felt.taken;
    far_given_ = felt.given;
  }
}

ArmForce ArmHand::fill(HandInput& input) {
  view_ = servo_.view();
  HandPose& hand = input.hands[settings_.hand];
  hand.tracked = view_.reading.valid;
  if (hand.tracked) hand.pose = view_.reading.stylus;
  hand.flexion = pointing;
  const std::uint32_t pressed = view_.reading.buttons & ~buttons_;
  buttons_ = view_.reading.buttons;
  hand.buttons = buttons_;
  if ((pressed & first_button) != 0) {
    holds_ = !holds_;
    const auto own_hand = static_cast<std::uint8_t>(settings_.hand);
    wishes_.push_back(holds_ ? CommandBody(Grasp{own_hand}) : CommandBody(Release{own_hand}));
  }
  ArmForce out;
  out.participant = input.participant;
  out.hand = static_cast<std::uint8_t>(settings_.hand);
  out.sequence = ++sequence_;
  out.force = view_.force;
  out.taken = view_.energy.taken;
  out.given = view_.energy.given;
  return out;
}

std::vector<CommandBody> ArmHand::take_wishes() {
  return std::exchange(wishes_, {});
}

std::vector<std::string> ArmHand::take_news() {
  if (view_.status.health == reported_health_ && view_.status.message == reported_message_) return {};
  reported_health_ = view_.status.health;
  reported_message_ = view_.status.message;
  return {fmt::format("arm {}: {}{}{}", settings_.address, words_of(reported_health_),
                      reported_message_.empty() ? "" : ": ", reported_message_)};
}

}  // namespace prosector
