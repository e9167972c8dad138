#include "drivers/real_time.h"

#include <pthread.h>
#include <sched.h>

namespace prosector {

bool ask_for_real_time(int priority) {
  sched_param wanted{};
  wanted.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0;
}

}  // namespace prosector
