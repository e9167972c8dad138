#pragma once
// Rate limit per writer and topic, with the limits of the topic table.

#include <map>
#include <utility>

#include "idl/token_bucket.h"
#include "idl/topics.h"

namespace prosector {

class RateGate {
 public:
  bool admits(std::size_t topic, std::uint64_t writer, std::int64_t now_ns);

 private:
  std::map<std::pair<std::size_t, std::uint64_t>, TokenBucket> buckets_;
};

}  // namespace prosector
