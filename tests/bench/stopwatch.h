#pragma once
// How long a call takes.

#include <algorithm>
#include <chrono>
#include <vector>

namespace prosector {

/// Median over `repeats` calls after a few to warm up, milliseconds.
template <class F>
double median_ms(int repeats, const F& f) {
  using Clock = std::chrono::steady_clock;
  for (int i = 0; i < 3; ++i) f();
  std::vector<double> ms;
  for (int i = 0; i < repeats; ++i) {
    const auto start = Clock::now();
    f();
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  const auto middle = ms.begin() + repeats / 2;
  std::nth_element(ms.begin(), middle, ms.end());
  return *middle;
}

}  // namespace prosector
