#include "idl/dds/timed_wait.h"

#include <algorithm>
#include <array>

namespace prosector {
namespace {

constexpr dds_attach_t is_condition = 0, is_alarm = 1;

}  // namespace

TimedWait::TimedWait(dds_entity_t participant)
    : waitset_(dds_create_waitset(participant), "waitset"),
      alarm_(dds_create_guardcondition(participant), "guard condition") {
  dds_waitset_attach(waitset_.get(), alarm_.get(), is_alarm);
}

TimedWait::~TimedWait() {
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  changed_.notify_one();
  if (timer_.joinable()) timer_.join();
}

void TimedWait::attach(dds_entity_t condition) {
  dds_waitset_attach(waitset_.get(), condition, is_condition);
}

bool TimedWait::wait(std::chrono::nanoseconds timeout) {
  if (!timer_.joinable()) timer_ = std::thread([this] { run_timer(); });
  set_alarm(Clock::now() + timeout);
  std::array<dds_attach_t, 64> woken;
  const dds_return_t count = dds_waitset_wait(waitset_.get(), woken.data(), woken.size(), DDS_INFINITY);
  set_alarm(std::nullopt);
  const auto told = static_cast<std::size_t>(std::clamp<dds_return_t>(count, 0, woken.size()));
  return std::find(woken.begin(), woken.begin() + static_cast<std::ptrdiff_t>(told), is_condition) !=
         woken.begin() + static_cast<std::ptrdiff_t>(told);
}

void TimedWait::set_alarm(std::optional<Clock::time_point> due) {
  {
    const std::scoped_lock lock(mutex_);
    dds_set_guardcondition(alarm_.get(), false);
    due_ = due;
  }
  changed_.notify_one();
}

void TimedWait::run_timer() {
  std::unique_lock lock(mutex_);
  while (!ended_) {
    if (!due_) {
      changed_.wait(lock);
    } else if (Clock::now() < *due_) {
      const Clock::time_point due = *due_;
      changed_.wait_until(lock, due);
    } else {
      dds_set_guardcondition(alarm_.get(), true);
      due_.reset();
    }
  }
}

}  // namespace prosector
