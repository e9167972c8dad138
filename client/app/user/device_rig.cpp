#include "client/app/user/device_rig.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>

#include "common/clock.h"
#include "common/rotation_between.h"
#include "drivers/camera/devices/shared_camera.h"
#include "drivers/config/tracker_roles.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

std::string without_digits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

/// Returns the tip's pose with +z along the shaft: towards the tracked sensor if the mount gives a distance
/// of at least 1 cm, else with the tip's own orientation.
Pose along_shaft(const Pose& tip, const Pose& mount) {
  constexpr double shortest_shaft = 0.01;  // m
  const Vec3 shaft = mount.inverse().p;
  if (shaft.norm() < shortest_shaft) return tip;
  return {tip.p, tip.q * rotation_between(Vec3::UnitZ(), shaft)};
}

constexpr std::uint32_t first_button = 1;
constexpr double tablet_lost_delay = 1;  // s, after which its absence is reported

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
      headset_gestures_{GestureDetector(config.gloves[left_hand].device.gestures),
                        GestureDetector(config.gloves[right_hand].device.gestures)},
      eye_(config.tracker_device.placement.room_device.p) {
  if (!config_.tracker.empty()) open_tracker();
  for (std::size_t hand : {left_hand, right_hand})
    if (const GloveSettings& glove = config_.gloves[hand]; !glove.address.empty())
      open(hand == right_hand ? "right glove" : "left glove", glove.address, glove.device, hand);
}

/// Opens the tracker. If a camera detects boards as well as bare hands, the board detector is opened first,
/// so that the table's board gives the camera pose used for the hands.
void DeviceRig::open_tracker() {
  const DriverRow& driver = driver_of(config_.tracker);
  apply_driver_roles(config_);
  DeviceConfig& device = config_.tracker_device;
  const bool has_boards = std::any_of(device.tags.boards.begin() + 2, device.tags.boards.end(),
                                      [](const std::string& board) { return !board.empty(); });
  if (driver.fixes_hand_stations && driver.is_camera && (has_boards || !device.camera.table.empty())) {
    device.camera.shared = shared_camera(device.camera.shared, first_camera(config_.tracker));
    open("boards", board_tracker_address(config_.tracker), device, std::nullopt);
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
      const auto hand = entry.glove_hand ? entry.glove_hand : hand_without_glove(sample.station);
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

/// Returns the hand of a tracker station, unless this hand has a glove.
std::optional<std::size_t> DeviceRig::hand_without_glove(std::uint32_t station) const {
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
    if (appears)
      gesture_[hand] =
          configured_gesture(bends.gesture);  // a gesture made when the hand appears triggers nothing
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
    take_held(HeldObject::tablet, sample, sample.pose, now_ns);
  } else if (role == StationRole::instrument) {
    take_held(HeldObject::stylus, sample,
              along_shaft(sample.pose, config_.tracker_device.placement.mount[sample.station]), now_ns);
  }
}

void DeviceRig::take_held(HeldObject thing, const DeviceSample& sample, const Pose& pose,
                          std::int64_t now_ns) {
  const auto index = static_cast<std::size_t>(thing);
  input_.held[index] = {true, pose};
  held_life_[index].see(sample.time_ns, now_ns);
}

/// Lets bare hands in front of a camera operate the user's tablet.
void DeviceRig::press_tablet() {
  if (config_.tracker.empty()) return;
  const DriverRow& driver = driver_of(config_.tracker);
  if (!driver.fixes_hand_stations || !driver.is_camera) return;
  const auto& camera = config_.tracker_device.camera.shared;
  const std::optional<Pose> seen = camera ? camera->room_camera() : std::nullopt;
  if (seen) eye_ = seen->p;
  const HeldPose& tablet = input_.held[static_cast<std::size_t>(HeldObject::tablet)];
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

/// Returns the gesture to look up in the configuration: this one if the configuration names it, else the same
/// fingers' gesture regardless of the thumb.
Gesture DeviceRig::configured_gesture(Gesture made) const {
  return config_.gestures.contains(made) ? made : without_thumb(made);
}

void DeviceRig::take_glove(std::size_t hand, const DeviceSample& sample) {
  input_.hands[hand].flexion = sample.flexion;
  input_.hands[hand].gesture = sample.gesture;
  // Between two gestures the hand reports none; only a different one triggers an event.
  const Gesture asked = configured_gesture(sample.gesture);
  if (asked == Gesture::none || asked == gesture_[hand]) return;
  gesture_[hand] = asked;
  if (const auto it = config_.gestures.find(asked); it != config_.gestures.end())
    triggers_.push_back({it->second, hand});
}

/// Handles the buttons of a device without finger sensors: the first button alternates between grasp and
/// release.
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
    out.push_back(fmt::format("{}: {}{}{}", entry.label, health_name(status.health),
                              status.message.empty() ? "" : ": ", status.message));
  }
  const std::size_t tablet = static_cast<std::size_t>(HeldObject::tablet);
  const bool rests = held_life_[tablet].seen_ns() != 0 && !input_.held[tablet].tracked &&
                     seconds_since(held_life_[tablet].seen_ns()) > tablet_lost_delay;
  if (rests != tablet_rests_ && (rests || input_.held[tablet].tracked)) {
    tablet_rests_ = rests;
    out.emplace_back(rests ? "tablet: not detected; the panel stays where it was and will soon be released"
                           : "tablet: detected again");
  }
  return out;
}

}  // namespace prosector
