#pragma once
// PROSECTOR_ASSERT: checks of internal preconditions that no input can violate; bad input is an InputError
// instead. Enabled by the option PROSECTOR_ASSERTIONS, which the presets asan, asan-full and tsan set.

#include <algorithm>
#include <functional>

namespace prosector {

/// Reports a violated assertion: throws InternalError that names the file, the line and the condition.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

/// Returns whether each value of the range is greater than the one before it (strictly ascending).
template <class Range>
bool is_ascending(const Range& range) {
  return std::ranges::adjacent_find(range, std::greater_equal<>()) == std::ranges::end(range);
}

}  // namespace prosector

// Without PROSECTOR_ASSERTIONS the condition is compiled but never evaluated.
#ifdef PROSECTOR_ASSERTIONS
#define PROSECTOR_ASSERT(...) \
  ((__VA_ARGS__) ? static_cast<void>(0) : ::prosector::assertion_failed(#__VA_ARGS__, __FILE__, __LINE__))
#else
#define PROSECTOR_ASSERT(...) static_cast<void>(sizeof((__VA_ARGS__) ? 1 : 0))
#endif
