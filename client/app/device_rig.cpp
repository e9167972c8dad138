#include "client/app/device_rig.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>

#include "common/clock.h"
#include "common/rotation_between.h"
#include "drivers/camera/shared_camera.h"
#include "drivers/tracker_roles.h"

namespace prosector {
namespace {

std::string without_digits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

/// Returns the pose of a tip whose +z is along the shaft. That is towards what is tracked, where the mount
/// says how far away it is, else as the tip is turned.
Pose along_shaft(const Pose& tip, const Pose& mount) {
  constexpr double shortest_shaft = 0.01;  // m
  const Vec3 shaft = mount.inverse().p;
  if (shaft.norm() < shortest_shaft) return tip;
  return {tip.p, tip.q * rotation_between(Vec3::UnitZ(), shaft)};
}

constexpr std::uint32_t first_button = 1;
constexpr double unseen_tablet = 1;  // s, after which it says so

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
      headset_gestures_{GestureDetector(thresholds_of(config.gloves[left_hand].device)),
                        GestureDetector(thresholds_of(config.gloves[right_hand].device))},
      eye_(config.tracker_device.room_device.p) {
  if (!config_.tracker.empty()) open_tracker();
  for (std::size_t hand : {left_hand, right_hand})
    if (const GloveSettings& glove = config_.gloves[hand]; !glove.address.empty())
      open(hand == right_hand ? "right glove" : "left glove", glove.address, glove.device, hand);
}

/// Opens the tracker. Boards that a camera is to see beside bare hands are looked for first, so that hands
/// know from the table's board where the camera stands.
void DeviceRig::open_tracker() {
  const DriverRow& driver = driver_of(config_.tracker);
  settle_roles(config_);
  DeviceConfig& device = config_.tracker_device;
  const bool has_boards = std::any_of(device.boards.begin() + 2, device.boards.end(),
                                      [](const std::string& board) { return !board.empty(); });
  if (driver.knows_hands && driver.is_camera && (has_boards || !device.table.empty())) {
    device.camera = shared_camera(device.camera, first_camera(config_.tracker));
    open("boards", boards_address(config_.tracker), device, std::nullopt);
  }
  open("tracker", config_.tracker, device, std::nullopt);
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
      if (sample.has_pose) take_tracker(sample, now_ns);
      const auto hand = entry.glove_hand ? entry.glove_hand : ungloved_hand(sample.station);
      if (hand && sample.has_flexion) take_glove(*hand, sample);
      if (hand && !sample.has_flexion) take_buttons(*hand, sample);
      changed = true;
    }
  }
  if (const auto user = headset_ != nullptr ? headset_->take() : std::nullopt) {
    take_headset(*user, now_ns);
    changed = true;
  }
  expire(now_ns);
  if (changed) press_tablet();
  return changed;
}

/// Returns the hand of a tracker's station, unless it has a glove.
std::optional<std::size_t> DeviceRig::ungloved_hand(std::uint32_t station) const {
  const StationRole role = station < max_stations ? config_.stations[station] : StationRole::none;
  if (role != StationRole::right_hand && role != StationRole::left_hand) return std::nullopt;
  const std::size_t hand = role == StationRole::right_hand ? right_hand : left_hand;
  return config_.gloves[hand].address.empty() ? std::optional(hand) : std::nullopt;
}

void DeviceRig::take_headset(const TrackedUser& user, std::int64_t now_ns) {
  input_.time_ns = user.time_ns;
  if (user.head) {
    input_.head_tracked = true;
    input_.head = *user.head;
    head_life_.see(user.time_ns, now_ns);
  }
  for (std::size_t hand : {left_hand, right_hand}) {
    if (!user.hands[hand]) continue;
    HandPose& mine = input_.hands[hand];
    const bool appears = !std::exchange(mine.tracked, true);
    mine.pose = user.hands[hand]->wrist;
    const std::uint32_t pressed =
        user.hands[hand]->buttons & ~std::exchange(mine.buttons, user.hands[hand]->buttons);
    if ((pressed & menu_button) != 0 && !appears) triggers_.push_back({GestureEvent::panel, hand});
    hand_life_[hand].see(user.time_ns, now_ns);
    DeviceSample bends;
    bends.flexion = user.hands[hand]->flexion;
    bends.gesture = headset_gestures_[hand].update(bends.flexion);
    if (appears) gesture_[hand] = asked_gesture(bends.gesture);  // coming into sight it asks for nothing
    take_glove(hand, bends);
  }
}

void DeviceRig::take_tracker(const DeviceSample& sample, std::int64_t now_ns) {
  const StationRole role =
      sample.station < max_stations ? config_.stations[sample.station] : StationRole::none;
  input_.time_ns = sample.time_ns;
  if (role == StationRole::head) {
    input_.head_tracked = true;
    input_.head = sample.pose;
    head_life_.see(sample.time_ns, now_ns);
  } else if (role == StationRole::right_hand || role == StationRole::left_hand) {
    const std::size_t hand = role == StationRole::right_hand ? right_hand : left_hand;
    input_.hands[hand].tracked = true;
    input_.hands[hand].pose = seen_wrists_[hand] = sample.pose;
    input_.hands[hand].buttons = sample.buttons;
    tracker_sample_[hand] = sample;
    hand_life_[hand].see(sample.time_ns, now_ns);
  } else if (role == StationRole::tablet) {
    take_held(HeldThing::tablet, sample, sample.pose, now_ns);
  } else if (role == StationRole::instrument) {
    take_held(HeldThing::stylus, sample,
              along_shaft(sample.pose, config_.tracker_device.mount[sample.station]), now_ns);
  }
}

void DeviceRig::take_held(HeldThing thing, const DeviceSample& sample, const Pose& pose,
                          std::int64_t now_ns) {
  const auto index = static_cast<std::size_t>(thing);
  input_.held[index] = {true, pose};
  held_life_[index].see(sample.time_ns, now_ns);
}

/// Lets bare hands before a camera work the user's tablet.
void DeviceRig::press_tablet() {
  if (config_.tracker.empty()) return;
  const DriverRow& driver = driver_of(config_.tracker);
  if (!driver.knows_hands || !driver.is_camera) return;
  const auto& camera = config_.tracker_device.camera;
  const std::optional<Pose> seen = camera ? camera->room_camera() : std::nullopt;
  if (seen) eye_ = seen->p;
  const HeldPose& tablet = input_.held[static_cast<std::size_t>(HeldThing::tablet)];
  for (std::size_t hand : {left_hand, right_hand}) {
    HandPose& mine = input_.hands[hand];
    if (!mine.tracked) {
      press_.lose(hand);
      continue;
    }
    mine.pose = seen_wrists_[hand];
    if (tablet.tracked) mine = press_.follow(hand, mine, tablet.pose, eye_, hand_life_[hand].seen_ns());
  }
}

/// Returns what asks where this gesture is made: itself where the configuration names it, else the same
/// fingers' whatever the thumb does.
Gesture DeviceRig::asked_gesture(Gesture made) const {
  return config_.gestures.contains(made) ? made : without_thumb(made);
}

void DeviceRig::take_glove(std::size_t hand, const DeviceSample& sample) {
  input_.hands[hand].flexion = sample.flexion;
  input_.hands[hand].gesture = sample.gesture;
  // Between two gestures a hand makes none; only a new one triggers.
  const Gesture asked = asked_gesture(sample.gesture);
  if (asked == Gesture::none || asked == gesture_[hand]) return;
  gesture_[hand] = asked;
  if (const auto it = config_.gestures.find(asked); it != config_.gestures.end())
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
  for (std::size_t thing = 0; thing < held_things; ++thing)
    if (held_life_[thing].is_over(now_ns)) input_.held[thing].tracked = false;
  if (head_life_.is_over(now_ns)) input_.head_tracked = false;
  for (std::size_t hand : {left_hand, right_hand})
    if (hand_life_[hand].is_over(now_ns)) {
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
  const std::size_t tablet = static_cast<std::size_t>(HeldThing::tablet);
  const bool rests = held_life_[tablet].seen_ns() != 0 && !input_.held[tablet].tracked &&
                     seconds_since(held_life_[tablet].seen_ns()) > unseen_tablet;
  if (rests != tablet_rests_ && (rests || input_.held[tablet].tracked)) {
    tablet_rests_ = rests;
    out.emplace_back(rests ? "tablet: it isn't seen; the panel rests where it was, and is soon let go"
                           : "tablet: it is seen again");
  }
  return out;
}

}  // namespace prosector
