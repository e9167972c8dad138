#pragma once
// A user's devices together: tracker stations and gloves become one HandInput and gesture events.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/app/headset_user.h"
#include "client/app/pose_life.h"
#include "client/app/tablet_press.h"
#include "common/messages.h"
#include "drivers/client_config.h"
#include "drivers/device.h"
#include "drivers/gesture.h"

namespace prosector {

struct GestureTrigger {
  GestureEvent event = GestureEvent::none;
  std::size_t hand = right_hand;
};

/// Returns drivers in use, for people: "fastrak, 5dt"; empty when the configuration names no device.
std::string describe_devices(const ClientConfig& config);
inline bool has_devices(const ClientConfig& config) {
  return !describe_devices(config).empty();
}

class DeviceRig {
 public:
  /// Opens what the configuration names; devices that can't be opened yet are retried and reported, never
  /// fatal. `headset` tracks the user, too; null: none does.
  explicit DeviceRig(const ClientConfig& config, HeadsetUser* headset = nullptr);

  /// Blocks until a device has something or the time is over.
  void wait(int timeout_ms) const;
  /// Reads all devices. Returns true if any pose or flexion changed.
  bool poll(std::int64_t now_ns);

  /// Returns the latest state of the user; `participant` and `sequence` are the sender's to fill.
  const HandInput& input() const { return input_; }
  /// Returns the tracker sample that `input().hands[hand]` stands on, if it has one.
  const std::optional<DeviceSample>& tracker_sample(std::size_t hand) const { return tracker_sample_[hand]; }
  /// Returns what gestures triggered since the last call.
  std::vector<GestureTrigger> take_triggers() { return std::exchange(triggers_, {}); }
  /// Returns lines for people about every device whose state changed since the last call: "tracker
  /// fastrak:/dev/ttyS0: silent …".
  std::vector<std::string> take_news();

 private:
  struct Entry {
    std::string label;
    std::unique_ptr<Device> device;
    std::optional<std::size_t> glove_hand;  // nullopt: the tracker
    DeviceHealth reported = DeviceHealth::connecting;
    std::string reported_words = {};  // of its message; counts in it may change without a report
  };

  ClientConfig config_;
  HeadsetUser* headset_;
  std::array<GestureDetector, 2> headset_gestures_;
  std::vector<Entry> devices_;
  HandInput input_;
  std::array<std::optional<DeviceSample>, 2> tracker_sample_;
  std::array<PoseLife, 2> hand_life_;
  PoseLife head_life_;
  std::array<PoseLife, held_things> held_life_;
  bool tablet_rests_ = false;        // as was told last
  TabletPress press_;                // of bare hands before a camera
  std::array<Pose, 2> seen_wrists_;  // as the camera has them
  Vec3 eye_ = Vec3::Zero();          // m, room: where the camera was last
  std::array<Gesture, 2> gesture_{};
  std::array<std::uint32_t, 2> buttons_{};
  std::array<bool, 2> holds_{};
  std::vector<GestureTrigger> triggers_;
  std::vector<DeviceSample> samples_;

  void open_tracker();
  void open(const std::string& role, const std::string& address, const DeviceConfig& config,
            std::optional<std::size_t> glove_hand);
  std::optional<std::size_t> ungloved_hand(std::uint32_t station) const;
  void take_buttons(std::size_t hand, const DeviceSample& sample);
  void take_headset(const TrackedUser& user, std::int64_t now_ns);
  void take_held(HeldThing thing, const DeviceSample& sample, const Pose& pose, std::int64_t now_ns);
  void press_tablet();
  void take_tracker(const DeviceSample& sample, std::int64_t now_ns);
  void take_glove(std::size_t hand, const DeviceSample& sample);
  Gesture asked_gesture(Gesture made) const;
  void expire(std::int64_t now_ns);
};

}  // namespace prosector
