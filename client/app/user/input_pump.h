#pragma once
// Thread that reads devices and sends inputs: a hand pose is sent as soon as its record is complete,
// independently of the frame rate.

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "client/app/session/connection.h"
#include "client/app/user/arm_hand.h"
#include "client/app/user/config_watch.h"
#include "client/app/user/device_rig.h"
#include "client/app/user/tool_hand.h"

namespace prosector {

class InputPump {
 public:
  /// Starts the thread that reads the user's devices and sends inputs to the server. `headset`: a headset
  /// that also tracks the user; `arm`: the hand moved by a haptic arm; null: none. Later changes of the
  /// configuration file are applied, except to the arm.
  ///
  /// `log`, if not empty, is a CSV file with a line per sent HandInput: sequence, monotonic ns, time of the
  /// device's sample, and the tracker's raw values. Matching these values with the device's own log gives the
  /// end-to-end latency.
  InputPump(Connection& connection, const ConfigSource& source, HeadsetUser* headset, ArmHand* arm,
            const std::filesystem::path& log, std::function<void(const std::string&)> report);
  ~InputPump();

  /// Returns the user's last input that was sent to the server, for immediate rendering of the own hands.
  HandInput latest() const;
  /// Sets the input that a user without devices makes with mouse and keyboard. It is sent at a constant rate,
  /// so that a slow frame doesn't look like a lost hand.
  void set_desk_input(const HandInput& input);
  /// Returns and removes the hands (left_hand, right_hand) whose gestures have requested `event` since the
  /// last call: reset, panel or parts. The render thread determines the body concerned.
  std::vector<std::size_t> take_calls(GestureEvent event);

 private:
  Connection& connection_;
  ConfigWatch watch_;
  HeadsetUser* headset_;
  std::unique_ptr<DeviceRig> rig_;
  std::string tool_;  // name of the blade that the user's instrument controls; empty: none
  ToolHand tool_hand_;
  std::string tool_problem_;  // last reported problem with it
  ArmHand* arm_;
  std::ofstream log_;
  std::function<void(const std::string&)> report_;
  mutable std::mutex mutex_;
  HandInput latest_;
  std::optional<HandInput> desk_input_;
  std::map<GestureEvent, std::vector<std::size_t>> calls_;  // hands, by requested event
  std::jthread thread_;

  void run(std::stop_token stop);
  void take_config(const ClientConfig& config);
  void obey(const GestureTrigger& trigger);
  void drive_tool_hand(HandInput& input, std::int64_t now_ns);
  bool desk_driven() const;
  void send(std::int64_t now_ns, std::uint64_t sequence);
};

}  // namespace prosector
