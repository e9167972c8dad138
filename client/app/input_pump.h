#pragma once
// The thread between devices and network: a hand pose leaves as soon as its record is whole, not when a
// picture is drawn.

#include <filesystem>
#include <fstream>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "client/app/arm_hand.h"
#include "client/app/config_watch.h"
#include "client/app/connection.h"
#include "client/app/device_rig.h"
#include "client/app/tool_hand.h"

namespace prosector {

class InputPump {
 public:
  /// Starts sending. `log`, if not empty, is a CSV with one line per HandInput sent: sequence, monotonic ns,
  /// when devices saw it, the tracker's raw values. It lets latency be measured end to end, by matching the
  /// values with those that the device says it sent. `headset` tracks the user, too, and `arm` is the hand
  /// that an arm moves; null: none does. What is written into the configuration's file meanwhile is taken
  /// over, but for the arm.
  InputPump(Connection& connection, const ConfigSource& source, HeadsetUser* headset, ArmHand* arm,
            const std::filesystem::path& log, std::function<void(const std::string&)> report);
  ~InputPump();

  /// Returns the user as the devices have them now: drawn at once.
  HandInput latest() const;
  /// Sets, for a user without devices, what mouse and keyboard make of them. Sent at a steady rate, so that a
  /// picture that takes long doesn't look like a hand that is gone.
  void set_desk_input(const HandInput& input);
  /// Returns hands whose gestures asked for a panel since the last call: which one is for the drawing side to
  /// see.
  std::vector<std::size_t> take_panel_calls();
  /// Returns hands whose gestures asked for the list of parts since the last call.
  std::vector<std::size_t> take_parts_calls();

 private:
  Connection& connection_;
  ConfigWatch watch_;
  HeadsetUser* headset_;
  std::unique_ptr<DeviceRig> rig_;
  std::string tool_;  // that the user's instrument is; empty: none
  ToolHand tool_hand_;
  std::string tool_problem_;  // as was told last
  ArmHand* arm_;
  std::ofstream log_;
  std::function<void(const std::string&)> report_;
  mutable std::mutex mutex_;
  HandInput latest_;
  std::optional<HandInput> desk_input_;
  std::vector<std::size_t> panel_calls_, parts_calls_;
  std::jthread thread_;

  void run(std::stop_token stop);
  void take_config(const ClientConfig& config);
  void obey(const GestureTrigger& trigger);
  void lead_tool(HandInput& input, std::int64_t now_ns);
  bool desk_driven() const;
  void send(std::int64_t now_ns, std::uint64_t sequence);
};

}  // namespace prosector
