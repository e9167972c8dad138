// Makes Cyclone DDS wait on the monotonic clock. Release 0.10 waits for wall-clock times. If the wall clock
// is set back by an hour, its events (discovery, heartbeats, leases, resends) stop for an hour. All peers
// then assume that the process has left (Cyclone's issue 1995, fixed after 0.10).
//
// The two functions below replace Cyclone's functions of the same name and contract (dds/ddsrt/sync.h).
// Definitions in an executable take precedence over those of a shared library. CMake's --undefined keeps the
// linker from dropping them.

#include <dds/ddsrt/sync.h>
#include <dds/ddsrt/time.h>

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace {

constexpr std::int64_t second_ns = 1'000'000'000;
constexpr std::int64_t longest_ns = 365 * 24 * 3600 * second_ns;  // avoids overflow of sums

}  // namespace

/// Waits for the condition for at most `reltime` nanoseconds. Returns false after a timeout.
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

/// Waits for the condition until the wall-clock time `abstime`, converted to a duration now. Returns false
/// after a timeout.
extern "C" bool ddsrt_cond_waituntil(ddsrt_cond_t* cond, ddsrt_mutex_t* mutex, dds_time_t abstime) {
  return ddsrt_cond_waitfor(cond, mutex, abstime == DDS_NEVER ? DDS_INFINITY : abstime - dds_time());
}
