#pragma once
// Waiting for samples by the monotonic clock. Cyclone's own time limits are moments of the wall clock: where
// somebody sets that back by an hour, they end an hour late.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "idl/dds/entity.h"

namespace prosector {

/// A wait set with a time limit that holds. Used by one thread at a time.
class TimedWait {
 public:
  explicit TimedWait(dds_entity_t participant);
  ~TimedWait();
  TimedWait(const TimedWait&) = delete;
  TimedWait& operator=(const TimedWait&) = delete;

  void attach(dds_entity_t condition);
  /// True at once or as soon as one of the conditions is; false when none was before `timeout` had passed.
  bool wait(std::chrono::nanoseconds timeout);

 private:
  using Clock = std::chrono::steady_clock;

  Entity waitset_, alarm_;  // alarm: a guard condition, true when the time is up
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Clock::time_point> due_;  // of the alarm
  bool ended_ = false;
  std::thread timer_;  // started with the first wait

  void run_timer();
  void set_alarm(std::optional<Clock::time_point> due);
};

}  // namespace prosector
