#include "client/app/session/input_loss_detector.h"

#include <algorithm>
#include <utility>

namespace prosector {

void InputLossDetector::take_consumed(std::uint64_t sequence) {
  if (std::exchange(consumed_, sequence) == sequence) return;
  has_consumed_ = true;
  timeout_ns_ = initial_timeout_ns;
}

bool InputLossDetector::take_status(std::int64_t now_ns, bool time_advances) {
  const std::uint64_t sent = sent_.load(std::memory_order_relaxed);
  const bool sends = std::exchange(sent_before_, sent) != sent;
  const bool paused = now_ns - std::exchange(status_ns_, now_ns) > pause_ns;
  if (std::exchange(has_consumed_, false) || !sends || !time_advances || paused) since_ns_ = now_ns;
  if (now_ns - since_ns_ < timeout_ns_) return false;
  since_ns_ = now_ns;
  timeout_ns_ = std::min(4 * timeout_ns_, max_timeout_ns);
  return true;
}

}  // namespace prosector
