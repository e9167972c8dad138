#pragma once
// BusCounters that two threads may count into.

#include <mutex>

#include "idl/topics.h"
#include "idl/wire/checks.h"

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
  void dropped(std::size_t topic, Refusal reason) {
    const std::scoped_lock lock(mutex_);
    ++counters_.dropped[std::string(topics.at(topic).name) + ": " + reason];
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
