#pragma once
// Measures how long calls take.

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace prosector {

/// Returns the time of the monotonic clock in ms.
inline double wall_ms() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

/// Returns the CPU time in ms that this process has used, over all its threads. The time of other processes
/// doesn't count.
inline double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Returns the median of `values`; of an even number of values, the larger of the middle two. `values` must
/// not be empty.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace prosector
