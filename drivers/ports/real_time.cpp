#include "drivers/ports/real_time.h"

#include <pthread.h>
#include <sched.h>

namespace prosector {

bool request_real_time_priority(int priority) {
  sched_param wanted{};
  wanted.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0;
}

}  // namespace prosector
