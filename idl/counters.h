#pragma once
// Thread-safe BusCounters.

#include <mutex>

#include "common/refusal.h"
#include "idl/topics.h"

namespace prosector {

class EdgeCounters {
 public:
  void published(std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    ++counters_.published;
    counters_.bytes_out += bytes;
  }
  void taken() {
    const std::scoped_lock lock(mutex_);
    ++counters_.taken;
  }
  void received(std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    counters_.bytes_in += bytes;
  }
  void dropped(std::size_t topic, const Refusal& refusal) {
    const std::scoped_lock lock(mutex_);
    ++counters_.dropped[std::string(topics.at(topic).name) + ": " + refusal.why()];
    ++counters_.dropped_total;
  }
  BusCounters read() const {
    const std::scoped_lock lock(mutex_);
    return counters_;
  }

 private:
  mutable std::mutex mutex_;
  BusCounters counters_;
};

}  // namespace prosector
