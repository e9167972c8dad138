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
  /// Processes bytes from the host and appends the answers to `out`.
  virtual void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                       std::vector<TwinOutput>& out) = 0;
  /// Appends the records that are due.
  virtual void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) = 0;
  /// Returns the next time at which produce() has records.
  virtual std::int64_t due_ns(std::int64_t now_ns) const = 0;
  /// Resets the conversation with the client: the next client at a socket starts a new one.
  virtual void reset_client() {}
  /// Lets the script continue after its next hold.
  virtual void go_on(std::int64_t now_ns) = 0;
};

/// Time span of a fault, s.
struct FaultSpan {
  double from = 0, to = 0;
  bool contains(double t) const { return t >= from && t < to; }
};

/// Start, holds and looping of a twin's script.
struct TwinTiming {
  bool wait_client = false;  // script time 0 is the start of streaming, not the start of the twin
  bool loop = false;
  std::vector<double> holds = {};  // s, increasing: at each, script time pauses until go_on()
};

/// Clock of a twin's script.
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
  /// Releases the next hold. A hold that was not reached yet is skipped.
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
