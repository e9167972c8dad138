#pragma once
// Waits for a time of the clock that monotonic_ns() reads.

#include <cstdint>
#include <ctime>

namespace prosector {

/// Waits until the monotonic clock reads `ns` nanoseconds. Returns immediately if that time has passed.
inline void sleep_until(std::int64_t ns) {
  constexpr std::int64_t second_ns = 1'000'000'000;
  const timespec due{static_cast<time_t>(ns / second_ns), static_cast<long>(ns % second_ns)};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
}

}  // namespace prosector
