#pragma once
// Whether the server still hears what this client sends.

#include <atomic>
#include <cstdint>

namespace prosector {

/// Tells when a server that is there no longer consumes a client's inputs, though they are sent. One damaged
/// datagram can do that, if its sequence number is far ahead. The server's DDS reader then drops all that
/// follow as old ones, for as long as the same writer sends. sent() may be called on another thread than the
/// rest.
class UnheardInputs {
 public:
  /// Notes that an input was sent.
  void sent() { sent_.fetch_add(1, std::memory_order_relaxed); }
  /// Takes HandInput::sequence of the last input that the server consumed.
  void take_consumed(std::uint64_t sequence);
  /// Takes that the server told its status at this time of a monotonic clock, ns. `time_goes`: it consumes
  /// inputs, since simulated time doesn't stand still. Returns whether inputs were sent, but none consumed,
  /// for `patience`, and for longer each time; it then restarts the count.
  bool take_status(std::int64_t now_ns, bool time_goes);

  static constexpr std::int64_t patience_ns = 5'000'000'000, longest_patience_ns = 300'000'000'000;
  static constexpr std::int64_t pause_ns = 2'000'000'000;  // between statuses: the count restarts

 private:
  std::atomic<std::uint64_t> sent_ = 0;
  std::uint64_t sent_before_ = 0, consumed_ = 0;
  std::int64_t since_ns_ = 0, status_ns_ = 0;
  std::int64_t patience_ = patience_ns;
  bool has_consumed_ = true;
};

}  // namespace prosector
