#pragma once
// A simulated device: bytes in, bytes out, driven by a clock that its owner reads.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace prosector {

struct TwinOutput {
  std::vector<std::uint8_t> bytes;
  bool is_record = false;     // a data record (else an answer to a command)
  std::uint32_t station = 0;  // 0-based
  std::uint64_t record = 0;   // counts this station's records
  std::vector<float> values;  // exactly what the record says
};

class Twin {
 public:
  virtual ~Twin() = default;
  /// Takes bytes from the host; answers are appended to `out`.
  virtual void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                       std::vector<TwinOutput>& out) = 0;
  /// Appends the records that are due.
  virtual void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) = 0;
  /// Returns when produce() has work next.
  virtual std::int64_t due_ns(std::int64_t now_ns) const = 0;
  /// Forgets who was talked to: at a socket, a new client begins anew.
  virtual void hung_up() {}
  /// Lets the script pass its next hold.
  virtual void go_on(std::int64_t now_ns) = 0;
};

/// A span of time, s.
struct FaultSpan {
  double from = 0, to = 0;
  bool contains(double t) const { return t >= from && t < to; }
};

/// When a twin's script starts and how it goes on.
struct TwinTiming {
  bool wait_client = false;  // script time 0 is the first start of streaming, not the twin's own start
  bool loop = false;
  std::vector<double> holds = {};  // s, rising: at each, script time stands still until go_on()
};

/// The time of a twin's script.
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
  /// Passes the next hold: one that was not reached yet will not hold.
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
