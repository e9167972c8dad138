#include "drivers/arms/arm_exchange.h"

#include <algorithm>
#include <utility>

namespace prosector {

Vec3 ArmExchange::force(std::int64_t now_ns) {
  const TimedForce& newest = forces_.read();
  return newest.time_ns > 0 && now_ns - newest.time_ns <= quiet_ns ? newest.force : Vec3(Vec3::Zero());
}

ArmReading ArmExchange::reading(std::int64_t now_ns, const Pose& room_arm) {
  const ArmSample& newest = samples_.read();
  ArmReading out = newest.reading;
  const bool jumped = std::exchange(jumps_, newest.jumps) != newest.jumps;
  if (jumped || newest.time_ns == 0 || now_ns - newest.time_ns > quiet_ns) out.valid = false;
  out.stylus = room_arm * out.stylus;
  return out;
}

bool ArmExchange::silent(std::int64_t now_ns, std::int64_t opened_ns) {
  return now_ns - std::max(opened_ns, samples_.read().time_ns) > silence_timeout_ns;
}

}  // namespace prosector
