#pragma once
// Lets each writer send each topic no faster than the topic's row allows.

#include <map>
#include <utility>

#include "idl/topics.h"
#include "idl/wire/token_bucket.h"

namespace prosector {

class RateGate {
 public:
  bool admits(std::size_t topic, std::uint64_t writer, std::int64_t now_ns);

 private:
  std::map<std::pair<std::size_t, std::uint64_t>, TokenBucket> buckets_;
};

}  // namespace prosector
