#pragma once
// Detects that the server no longer receives this client's inputs.

#include <atomic>
#include <cstdint>

namespace prosector {

/// Detector of a server that runs but no longer consumes this client's inputs although they are sent. A
/// single damaged datagram with a sequence number far ahead can cause this. The server's DDS reader then
/// drops all following samples of the same writer as outdated. sent() may be called on another thread than
/// the other functions.
class InputLossDetector {
 public:
  /// Counts an input that this client sent to the server.
  void sent() { sent_.fetch_add(1, std::memory_order_relaxed); }
  /// Records the last of this client's inputs that the server reports as consumed, by its
  /// HandInput::sequence.
  void take_consumed(std::uint64_t sequence);
  /// Processes a status message of the server that was received at `now_ns` (monotonic clock).
  /// `time_advances`: simulated time advances, so the server should consume inputs. Returns whether inputs
  /// were sent but none was consumed for the timeout. After that it measures again with a longer timeout.
  bool take_status(std::int64_t now_ns, bool time_advances);

  static constexpr std::int64_t initial_timeout_ns = 5'000'000'000, max_timeout_ns = 300'000'000'000;
  static constexpr std::int64_t pause_ns = 2'000'000'000;  // longer gaps between statuses restart the count

 private:
  std::atomic<std::uint64_t> sent_ = 0;
  std::uint64_t sent_before_ = 0, consumed_ = 0;
  std::int64_t since_ns_ = 0, status_ns_ = 0;
  std::int64_t timeout_ns_ = initial_timeout_ns;
  bool has_consumed_ = true;
};

}  // namespace prosector
