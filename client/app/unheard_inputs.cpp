#include "client/app/unheard_inputs.h"

#include <algorithm>
#include <utility>

namespace prosector {

void UnheardInputs::take_consumed(std::uint64_t sequence) {
  if (std::exchange(consumed_, sequence) == sequence) return;
  unheard_ = 0;
  patience_ = patience;
}

bool UnheardInputs::take_status(bool time_goes) {
  const std::uint64_t sent = sent_.load(std::memory_order_relaxed);
  const bool sends = std::exchange(sent_before_, sent) != sent;
  unheard_ = sends && time_goes ? unheard_ + 1 : 0;
  if (unheard_ < patience_) return false;
  unheard_ = 0;
  patience_ = std::min(4 * patience_, longest_patience);
  return true;
}

}  // namespace prosector
