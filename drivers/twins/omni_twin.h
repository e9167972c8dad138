#pragma once
// A simulated PHANTOM Omni, held by a modelled hand that follows a script: registers and packets on a socket,
// mechanics behind them. It runs in the time that its owner gives it.

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "drivers/omni_packets.h"
#include "drivers/twins/arm_model.h"
#include "drivers/twins/motion_script.h"
#include "drivers/twins/twin.h"

namespace prosector {

struct OmniTwinOptions {
  MotionScript script;  // station 0: where the hand wants the stylus, in the room
  TwinTiming timing;
  Pose room_arm;
  HandImpedance hand = medium_hand;
  std::uint64_t seed = 1;
  double garbage = 0;  // probability that a packet is random bytes
};

class OmniTwin {
 public:
  explicit OmniTwin(OmniTwinOptions options, std::int64_t now_ns);

  std::uint32_t read(std::uint64_t address) const;
  void write(std::uint64_t address, std::span<const std::uint8_t> bytes, std::int64_t now_ns);
  void command(std::span<const std::uint8_t> packet);
  /// Moves on to `now_ns`. Returns the packet that it sends then; nothing: it doesn't stream.
  std::optional<std::array<std::uint8_t, omni::state_bytes>> advance(std::int64_t now_ns);
  void go_on(std::int64_t now_ns) { clock_.go_on(now_ns); }

  const ArmModel& model() const { return model_; }  // in the arm's frame
  bool streaming() const { return streaming_; }
  Vec3 intended() const { return intended_; }  // m, arm's frame
  std::uint64_t bad_commands() const { return bad_commands_; }

 private:
  struct Wish {
    Vec3 place, velocity;
  };
  Wish wish(std::int64_t now_ns) const;
  omni::State state() const;

  OmniTwinOptions options_;
  ScriptClock clock_;
  ArmModel model_;
  std::mt19937_64 random_;
  std::int64_t now_ns_, started_ns_ = 0;
  bool streaming_ = false, docked_ = true, motors_on_ = false;
  Vec3 intended_;
  std::array<int, 3> offset_{};  // of the encoders: where they were when it was switched on
  std::uint32_t count_ = 0;
  std::uint64_t bad_commands_ = 0;
};

}  // namespace prosector
