#pragma once
// Combines a user's devices: tracker stations and gloves become one HandInput and gesture events.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/app/user/headset_user.h"
#include "client/app/user/pose_validity.h"
#include "client/app/user/tablet_press.h"
#include "common/hand_messages.h"
#include "common/hand_pose.h"
#include "common/ids.h"
#include "common/math.h"
#include "drivers/config/client_config.h"
#include "drivers/device/device.h"
#include "drivers/device/gesture.h"

namespace prosector {

struct GestureTrigger {
  GestureEvent event = GestureEvent::none;
  std::size_t hand = right_hand;
};

/// Returns a list of the drivers of the configuration's devices, for display: "fastrak, 5dt"; empty if it
/// names no device.
std::string describe_devices(const ClientConfig& config);
inline bool has_devices(const ClientConfig& config) {
  return !describe_devices(config).empty();
}

class DeviceRig {
 public:
  /// Opens the configured tracker and gloves. A device that can't be opened is retried and reported; this is
  /// not fatal. `headset`: a headset that also tracks the user; null: none.
  explicit DeviceRig(const ClientConfig& config, HeadsetUser* headset = nullptr);

  /// Blocks until a tracker or glove has data, or the timeout expires.
  void wait(int timeout_ms) const;
  /// Reads all devices and updates input(). Returns true if any of them sent data.
  bool poll(std::int64_t now_ns);

  /// Returns the latest poses of the user's head, hands and held objects. The sender must fill in
  /// `participant` and `sequence`.
  const HandInput& input() const { return input_; }
  /// Returns the tracker sample from which the hand's pose in input() was computed; nullopt if there is none.
  const std::optional<DeviceSample>& tracker_sample(std::size_t hand) const { return tracker_sample_[hand]; }
  /// Returns and removes the events, such as grasp, that gestures and buttons have triggered since the last
  /// call, with the hand of each.
  std::vector<GestureTrigger> take_triggers() { return std::exchange(triggers_, {}); }
  /// Returns a line for the user for each device whose state changed since the last call: "tracker
  /// fastrak:/dev/ttyS0: silent …".
  std::vector<std::string> take_news();

 private:
  struct Entry {
    std::string label;
    std::unique_ptr<Device> device;
    std::optional<std::size_t> glove_hand;  // the hand that wears the glove; nullopt: a tracker
    DeviceHealth reported = DeviceHealth::connecting;
    std::string reported_words = {};  // of its message without digits: changed counts alone cause no report
  };

  ClientConfig config_;
  HeadsetUser* headset_;
  std::array<GestureDetector, 2> headset_gestures_;
  std::vector<Entry> devices_;
  HandInput input_;
  std::array<std::optional<DeviceSample>, 2> tracker_sample_;
  std::array<PoseValidity, 2> hand_life_;
  PoseValidity head_life_;
  std::array<PoseValidity, held_things> held_life_;
  bool tablet_rests_ = false;        // the last report said that the tablet is not detected
  TabletPress press_;                // for bare hands in front of a camera
  std::array<Pose, 2> seen_wrists_;  // as measured by the tracker
  Vec3 eye_ = Vec3::Zero();          // m, room: latest position of the camera
  std::array<Gesture, 2> gesture_{};
  std::array<std::uint32_t, 2> buttons_{};
  std::array<bool, 2> holds_{};
  std::vector<GestureTrigger> triggers_;
  std::vector<DeviceSample> samples_;

  void open_tracker();
  void open(const std::string& role, const std::string& address, const DeviceConfig& config,
            std::optional<std::size_t> glove_hand);
  std::optional<std::size_t> hand_without_glove(std::uint32_t station) const;
  void take_buttons(std::size_t hand, const DeviceSample& sample);
  void take_headset(const TrackedUser& user, std::int64_t now_ns);
  void take_held(HeldObject thing, const DeviceSample& sample, const Pose& pose, std::int64_t now_ns);
  void press_tablet();
  void take_tracker(const DeviceSample& sample, std::int64_t now_ns);
  void take_glove(std::size_t hand, const DeviceSample& sample);
  Gesture configured_gesture(Gesture made) const;
  void expire(std::int64_t now_ns);
};

}  // namespace prosector
