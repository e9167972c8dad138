// Makes Cyclone DDS wait by the monotonic clock. Its release 0.10 waits until moments of the wall clock.
// Where somebody sets that back by an hour, its events (discovery, heartbeats, leases, resends) rest for that
// hour. Every peer then takes the process for gone (Cyclone's issue 1995, mended after 0.10).
//
// The two functions below have the names and contracts of Cyclone's own (dds/ddsrt/sync.h). A program's
// definitions come before a shared library's, so Cyclone calls these. CMake's --undefined keeps them in.

#include <dds/ddsrt/sync.h>
#include <dds/ddsrt/time.h>

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace {

constexpr std::int64_t second_ns = 1'000'000'000;
constexpr std::int64_t longest_ns = 365 * 24 * 3600 * second_ns;  // so that no sum overflows

}  // namespace

/// Waits for the condition, `reltime` nanoseconds at most; false when that time passed.
extern "C" bool ddsrt_cond_waitfor(ddsrt_cond_t* cond, ddsrt_mutex_t* mutex, dds_duration_t reltime) {
  if (reltime == DDS_INFINITY) {
    ddsrt_cond_wait(cond, mutex);
    return true;
  }
  timespec until{};
  clock_gettime(CLOCK_MONOTONIC, &until);
  const std::int64_t ns = until.tv_nsec + std::clamp<std::int64_t>(reltime, 0, longest_ns);
  until = {.tv_sec = static_cast<time_t>(until.tv_sec + ns / second_ns),
           .tv_nsec = static_cast<long>(ns % second_ns)};
  return pthread_cond_clockwait(&cond->cond, &mutex->mutex, CLOCK_MONOTONIC, &until) == 0;
}

/// Waits for the condition until what the wall clock calls `abstime` now; false when that moment came.
extern "C" bool ddsrt_cond_waituntil(ddsrt_cond_t* cond, ddsrt_mutex_t* mutex, dds_time_t abstime) {
  return ddsrt_cond_waitfor(cond, mutex, abstime == DDS_NEVER ? DDS_INFINITY : abstime - dds_time());
}
