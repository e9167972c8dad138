#include "server/session/run/timed_turns.h"

#include <limits>

#include "common/assert.h"
#include "common/clock.h"
#include "server/session/run/sleep_until.h"
#include "server/session/run/tick_schedule.h"

namespace prosector {

std::uint64_t take(const TimedTurns& turns, const std::atomic<bool>& stop) {
  PROSECTOR_ASSERT(turns.tick_rate > 0 && turns.turn && turns.pace && turns.each_second);
  constexpr std::int64_t a_second = 1'000'000'000;
  const std::int64_t begin = monotonic_ns();
  const std::int64_t end = turns.seconds > 0 ? begin + static_cast<std::int64_t>(turns.seconds * 1e9)
                                             : std::numeric_limits<std::int64_t>::max();
  TickSchedule schedule(turns.tick_rate, begin);
  std::int64_t next_second = begin + a_second;
  while (!stop && schedule.due_ns() < end) {
    sleep_until(schedule.due_ns());
    turns.turn();
    const double pace = turns.pace();
    schedule.set_pace(pace == 0 ? 1 : pace);
    const std::int64_t now = monotonic_ns();
    if (now >= next_second) {
      turns.each_second();
      next_second += a_second * (1 + (now - next_second) / a_second);
    }
    schedule.finished(monotonic_ns());
  }
  return schedule.slips();
}

}  // namespace prosector
