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
  /// Takes that the server told its status: once a second. `time_goes`: it consumes inputs, since simulated
  /// time doesn't stand still. Returns whether, for `patience` of these and longer each time, inputs were
  /// sent and none was consumed; it then begins to count anew.
  bool take_status(bool time_goes);

  static constexpr int patience = 5, longest_patience = 300;  // statuses

 private:
  std::atomic<std::uint64_t> sent_ = 0;
  std::uint64_t sent_before_ = 0, consumed_ = 0;
  int unheard_ = 0, patience_ = patience;
};

}  // namespace prosector
