#include "idl/rate_gate.h"

namespace prosector {

bool RateGate::admits(std::size_t topic, std::uint64_t writer, std::int64_t now_ns) {
  const TopicSpec& spec = topics.at(topic);
  if (spec.rate == 0) return true;
  // Removes the buckets of silent writers, so that the table doesn't grow beyond the session's size.
  constexpr std::size_t many = 4096;
  if (buckets_.size() > many)
    std::erase_if(buckets_, [now_ns](const auto& entry) { return entry.second.full(now_ns); });
  const auto [bucket, fresh] = buckets_.try_emplace({topic, writer}, spec.rate, spec.burst);
  return bucket->second.take(now_ns);
}

}  // namespace prosector
