#include "drivers/ports/timestamped_buffer.h"

#include <algorithm>

namespace prosector {

void TimestampedBuffer::append(std::span<const std::uint8_t> bytes, std::int64_t time_ns) {
  if (bytes.empty()) return;
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(begin_));
  begin_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  appended_ += bytes.size();
  marks_.push_back({appended_, time_ns});
}

std::int64_t TimestampedBuffer::time_ns() const {
  return marks_.empty() ? 0 : marks_.front().time_ns;
}

void TimestampedBuffer::drop(std::size_t count) {
  count = std::min(count, bytes().size());
  begin_ += count;
  consumed_ += count;
  while (!marks_.empty() && marks_.front().end <= consumed_) marks_.pop_front();
}

void TimestampedBuffer::clear() {
  drop(bytes().size());
}

}  // namespace prosector
