#pragma once
// Interface of a simulated device: bytes in both directions, with time given by its owner.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace prosector {

struct TwinOutput {
  std::vector<std::uint8_t> bytes;
  bool is_record = false;     // data record, not an answer to a command
  std::uint32_t station = 0;  // 0-based
  std::uint64_t record = 0;   // counts this station's records
  std::vector<float> values;  // exact values in the record, as sent
};

class Twin {
 public:
  virtual ~Twin() = default;
  /// Processes bytes that the host sent to the simulated device and appends the answers to `out`.
  virtual void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                       std::vector<TwinOutput>& out) = 0;
  /// Appends the data records that the simulated device sends up to the time `now_ns`.
  virtual void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) = 0;
  /// Returns the next time (ns) at which produce() will have records to send.
  virtual std::int64_t due_ns(std::int64_t now_ns) const = 0;
  /// Resets the state of the conversation with the client, because a new client starts a new one. Does
  /// nothing for devices without such state.
  virtual void reset_client() {}
  /// Ends the current or the next hold of the motion script, a time at which the script pauses, so that the
  /// motion continues.
  virtual void go_on(std::int64_t now_ns) = 0;
};

/// Time span of a simulated fault, s; `to` is excluded.
struct FaultSpan {
  double from = 0, to = 0;
  bool contains(double t) const { return t >= from && t < to; }
};

/// Settings of the motion script that moves a simulated device: when it starts, at which times it pauses
/// (holds), and whether it repeats.
struct TwinTiming {
  bool wait_client = false;  // script time 0 is the start of streaming, not the start of the twin
  bool loop = false;
  std::vector<double> holds = {};  // s, increasing: at each, script time pauses until go_on()
};

/// Clock that converts real time to the time of the motion script that moves a simulated device. It pauses at
/// the script's holds.
class ScriptClock {
 public:
  ScriptClock(const TwinTiming& timing, std::int64_t now_ns)
      : start_ns_(now_ns), running_(!timing.wait_client), holds_(timing.holds) {}
  void streaming(std::int64_t now_ns) {
    if (!running_) start_ns_ = now_ns;
    running_ = true;
  }
  double seconds(std::int64_t now_ns) const {
    const double passed = running_ ? static_cast<double>(now_ns - start_ns_) * 1e-9 : 0.0;
    return next_ < holds_.size() ? std::min(passed, holds_[next_]) : passed;
  }
  /// Ends the motion script's next hold, a time at which the clock pauses, and continues from the present
  /// script time. A hold that was not reached yet is skipped.
  void go_on(std::int64_t now_ns) {
    if (next_ == holds_.size()) return;
    if (running_) start_ns_ = now_ns - static_cast<std::int64_t>(1e9 * seconds(now_ns));
    ++next_;
  }

 private:
  std::int64_t start_ns_;
  bool running_;
  std::vector<double> holds_;
  std::size_t next_ = 0;
};

}  // namespace prosector
