#pragma once
// A simulated device: bytes in, bytes out, driven by a clock that its owner reads.

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
  /// Bytes from the host; answers are appended to `out`.
  virtual void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                       std::vector<TwinOutput>& out) = 0;
  /// Appends the records that are due.
  virtual void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) = 0;
  /// When produce() has work next.
  virtual std::int64_t due_ns(std::int64_t now_ns) const = 0;
};

/// When a twin's script starts and how it goes on.
struct TwinTiming {
  bool wait_client = false;  // script time 0 is the first start of streaming, not the twin's own start
  bool loop = false;
};

/// Script time of a twin.
class ScriptClock {
 public:
  ScriptClock(const TwinTiming& timing, std::int64_t now_ns)
      : start_ns_(now_ns), running_(!timing.wait_client) {}
  void streaming(std::int64_t now_ns) {
    if (!running_) start_ns_ = now_ns;
    running_ = true;
  }
  double seconds(std::int64_t now_ns) const {
    return running_ ? static_cast<double>(now_ns - start_ns_) * 1e-9 : 0.0;
  }

 private:
  std::int64_t start_ns_;
  bool running_;
};

}  // namespace prosector
