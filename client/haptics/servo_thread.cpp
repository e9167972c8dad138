#include "client/haptics/servo_thread.h"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "common/clock.h"
#include "drivers/ports/real_time.h"

namespace prosector {
namespace {

constexpr std::int64_t second_ns = 1'000'000'000;
constexpr double bins_an_octave = 8;
constexpr std::uint64_t status_cycles = 100;  // cycles between two reads of the arm's status

void sleep_until(std::int64_t time_ns) {
  const timespec until{time_ns / second_ns, time_ns % second_ns};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

}  // namespace

ServoThread::ServoThread(std::unique_ptr<Arm> arm, const Pose& hand_of_stylus, std::uint32_t dead_man)
    : arm_(std::move(arm)),
      hand_of_stylus_(hand_of_stylus),
      dead_man_(dead_man),
      loop_(arm_->limits(), {}, hand_of_stylus.inverse().p) {
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

ServoThread::~ServoThread() {
  thread_.request_stop();
  thread_.join();
}

void ServoThread::feel(std::vector<ContactPlane> planes) {
  const std::lock_guard lock(mutex_);
  planes_ = std::move(planes);
}

ServoView ServoThread::view() {
  const std::lock_guard lock(mutex_);
  if (forces_ > 0) view_.force = force_sum_ / static_cast<double>(forces_);
  force_sum_.setZero();
  forces_ = 0;
  return view_;
}

void ServoThread::run(std::stop_token stop) {
  real_time_ = request_real_time_priority(servo_priority);
  const auto period = static_cast<std::int64_t>(second_ns / arm_->limits().rate);
  const std::int64_t start = monotonic_ns();
  std::int64_t next = start + period;
  while (!stop.stop_requested()) {
    sleep_until(next);
    const std::int64_t now = monotonic_ns();
    count_lateness(now - next);
    cycle(1e-9 * static_cast<double>(now - start));
    next += period;
    // Missed cycles are skipped: a burst of cycles would be felt.
    if (const std::int64_t behind = monotonic_ns() - next; behind > 0) {
      const std::int64_t missed = behind / period + 1;
      skipped_ += static_cast<std::uint64_t>(missed);
      next += missed * period;
    }
  }
  arm_->set_torque(Vec3::Zero());
  arm_->set_force(Vec3::Zero());
}

void ServoThread::cycle(double time) {
  ArmReading reading = arm_->read();
  reading.stylus = reading.stylus * hand_of_stylus_;
  if (std::unique_lock lock(mutex_, std::try_to_lock); lock && planes_) {
    loop_.take(*planes_, time);
    planes_.reset();
  }
  if (repeated_.exchange(false)) loop_.repeat_received(time);
  const bool let_go = dead_man_ != 0 && (reading.buttons & dead_man_) == 0;
  const Vec3 force = loop_.cycle(reading, time, !let_go);
  arm_->set_torque(loop_.torque());
  arm_->set_field(force, loop_.stiffness());
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;
  view_.reading = reading;
  view_.force_now = force;
  view_.energy = loop_.energy();
  view_.guard = loop_.guard();
  if (cycles_ % status_cycles == 1) view_.status = arm_->status();
  force_sum_ += force;
  ++forces_;
}

void ServoThread::count_lateness(std::int64_t late_ns) {
  ++cycles_;
  worst_ns_ = std::max(worst_ns_.load(), late_ns);
  const double octaves = std::log2(std::max(1., 1e-3 * static_cast<double>(late_ns)));
  const auto bin = static_cast<std::size_t>(bins_an_octave * octaves);
  ++late_[std::min(bin, late_.size() - 1)];
}

Lateness ServoThread::lateness() const {
  Lateness out;
  out.cycles = cycles_;
  out.skipped = skipped_;
  out.worst = 1e-9 * static_cast<double>(worst_ns_);
  std::uint64_t all = 0;
  for (const auto& count : late_) all += count;
  const auto quantile = [&](double share) {
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < late_.size(); ++i) {
      seen += late_[i];
      if (static_cast<double>(seen) >= share * static_cast<double>(all))
        return 1e-6 * std::exp2((static_cast<double>(i) + 1) / bins_an_octave);
    }
    return 0.;
  };
  if (all > 0) {
    out.p50 = quantile(0.5);
    out.p99 = quantile(0.99);
  }
  return out;
}

}  // namespace prosector
