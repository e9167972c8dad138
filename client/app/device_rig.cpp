#include "client/app/device_rig.h"

#include <fmt/format.h>
#include <poll.h>

namespace prosector {
namespace {

std::string without_digits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

constexpr std::uint32_t first_button = 1;
constexpr std::int64_t pose_lifetime_ns = 250'000'000;  // a pose older than this is no pose any more

/// Makes gestures of a headset's hand, by the thresholds that its glove would have.
GestureDetector gestures_of(const DeviceConfig& glove) {
  return GestureDetector({glove.closed_above, glove.open_below, glove.hysteresis, glove.pinch});
}

}  // namespace

std::string describe_devices(const ClientConfig& config) {
  std::string out;
  for (const std::string& address :
       {config.tracker, config.gloves[left_hand].address, config.gloves[right_hand].address})
    if (!address.empty()) out += (out.empty() ? "" : ", ") + parse_device_address(address).driver;
  if (!config.arm.address.empty())
    out += (out.empty() ? "" : ", ") + parse_arm_address(config.arm.address).driver;
  return out;
}

DeviceRig::DeviceRig(const ClientConfig& config, HeadsetUser* headset)
    : config_(config),
      headset_(headset),
      headset_gestures_{gestures_of(config.gloves[left_hand].device),
                        gestures_of(config.gloves[right_hand].device)} {
  if (!config_.tracker.empty() && driver_of(config_.tracker).knows_hands) {
    config_.stations = {StationRole::right_hand, StationRole::left_hand};
    config_.tracker_device.stations = 3;
  }
  if (!config_.tracker.empty() && driver_of(config_.tracker).knows_head) {
    config_.stations = {StationRole::head};
    config_.tracker_device.stations = 1;
  }
  if (!config_.tracker.empty()) open("tracker", config_.tracker, config_.tracker_device, std::nullopt);
  for (std::size_t hand : {left_hand, right_hand})
    if (const GloveSettings& glove = config_.gloves[hand]; !glove.address.empty())
      open(hand == right_hand ? "right glove" : "left glove", glove.address, glove.device, hand);
}

void DeviceRig::open(const std::string& role, const std::string& address, const DeviceConfig& config,
                     std::optional<std::size_t> glove_hand) {
  devices_.push_back({fmt::format("{} {}", role, address), open_device(address, config), glove_hand});
}

void DeviceRig::wait(int timeout_ms) const {
  std::vector<pollfd> descriptors;
  for (const Entry& entry : devices_)
    if (const int fd = entry.device->descriptor(); fd >= 0) descriptors.push_back({fd, POLLIN, 0});
  ::poll(descriptors.data(), descriptors.size(), timeout_ms);
}

bool DeviceRig::poll(std::int64_t now_ns) {
  bool changed = false;
  for (Entry& entry : devices_) {
    samples_.clear();
    entry.device->poll(samples_);
    for (const DeviceSample& sample : samples_) {
      if (sample.has_pose) take_tracker(sample);
      const auto hand = entry.glove_hand ? entry.glove_hand : ungloved_hand(sample.station);
      if (hand && sample.has_flexion) take_glove(*hand, sample);
      if (hand && !sample.has_flexion) take_buttons(*hand, sample);
      changed = true;
    }
  }
  if (const auto user = headset_ != nullptr ? headset_->take() : std::nullopt) {
    take_headset(*user);
    changed = true;
  }
  expire(now_ns);
  return changed;
}

/// Returns the hand of a tracker's station, unless it has a glove.
std::optional<std::size_t> DeviceRig::ungloved_hand(std::uint32_t station) const {
  const StationRole role = station < max_stations ? config_.stations[station] : StationRole::none;
  if (role != StationRole::right_hand && role != StationRole::left_hand) return std::nullopt;
  const std::size_t hand = role == StationRole::right_hand ? right_hand : left_hand;
  return config_.gloves[hand].address.empty() ? std::optional(hand) : std::nullopt;
}

void DeviceRig::take_headset(const TrackedUser& user) {
  input_.time_ns = user.time_ns;
  if (user.head) {
    input_.head_tracked = true;
    input_.head = *user.head;
    head_seen_ns_ = user.time_ns;
  }
  for (std::size_t hand : {left_hand, right_hand}) {
    if (!user.hands[hand]) continue;
    HandPose& mine = input_.hands[hand];
    const bool appears = !std::exchange(mine.tracked, true);
    mine.pose = user.hands[hand]->wrist;
    const std::uint32_t pressed =
        user.hands[hand]->buttons & ~std::exchange(mine.buttons, user.hands[hand]->buttons);
    if ((pressed & menu_button) != 0 && !appears) triggers_.push_back({GestureEvent::panel, hand});
    hand_seen_ns_[hand] = user.time_ns;
    DeviceSample bends;
    bends.flexion = user.hands[hand]->flexion;
    bends.gesture = headset_gestures_[hand].update(bends.flexion);
    if (appears) gesture_[hand] = bends.gesture;  // coming into sight it asks for nothing
    take_glove(hand, bends);
  }
}

void DeviceRig::take_tracker(const DeviceSample& sample) {
  const StationRole role =
      sample.station < max_stations ? config_.stations[sample.station] : StationRole::none;
  input_.time_ns = sample.time_ns;
  if (role == StationRole::head) {
    input_.head_tracked = true;
    input_.head = sample.pose;
    head_seen_ns_ = sample.time_ns;
  } else if (role == StationRole::right_hand || role == StationRole::left_hand) {
    const std::size_t hand = role == StationRole::right_hand ? right_hand : left_hand;
    input_.hands[hand].tracked = true;
    input_.hands[hand].pose = sample.pose;
    input_.hands[hand].buttons = sample.buttons;
    tracker_sample_[hand] = sample;
    hand_seen_ns_[hand] = sample.time_ns;
  }
}

void DeviceRig::take_glove(std::size_t hand, const DeviceSample& sample) {
  input_.hands[hand].flexion = sample.flexion;
  input_.hands[hand].gesture = sample.gesture;
  // Between two gestures a hand makes none; only a new one triggers.
  if (sample.gesture == Gesture::none || sample.gesture == gesture_[hand]) return;
  gesture_[hand] = sample.gesture;
  if (const auto it = config_.gestures.find(sample.gesture); it != config_.gestures.end())
    triggers_.push_back({it->second, hand});
}

/// Takes the buttons of what has no fingers: the first takes hold, and lets go again.
void DeviceRig::take_buttons(std::size_t hand, const DeviceSample& sample) {
  const std::uint32_t pressed = sample.buttons & ~buttons_[hand];
  buttons_[hand] = sample.buttons;
  if ((pressed & first_button) == 0) return;
  holds_[hand] = !holds_[hand];
  triggers_.push_back({holds_[hand] ? GestureEvent::grasp : GestureEvent::release, hand});
}

void DeviceRig::expire(std::int64_t now_ns) {
  if (now_ns - head_seen_ns_ > pose_lifetime_ns) input_.head_tracked = false;
  for (std::size_t hand : {left_hand, right_hand})
    if (now_ns - hand_seen_ns_[hand] > pose_lifetime_ns) {
      input_.hands[hand].tracked = false;
      tracker_sample_[hand].reset();
    }
}

std::vector<std::string> DeviceRig::take_news() {
  std::vector<std::string> out;
  for (Entry& entry : devices_) {
    const DeviceStatus status = entry.device->status();
    const std::string words = without_digits(status.message);
    if (status.health == entry.reported && words == entry.reported_words) continue;
    entry.reported = status.health;
    entry.reported_words = words;
    out.push_back(fmt::format("{}: {}{}{}", entry.label, health_word(status.health),
                              status.message.empty() ? "" : ": ", status.message));
  }
  return out;
}

}  // namespace prosector
