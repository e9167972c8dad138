#include "client/render/quality_governor.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {

QualityGovernor::QualityGovernor(double target) : target_(target) {
  if (!(target > 0) || !std::isfinite(target))
    throw InputError("target frame time (--frame-time): must be a number above 0");
}

bool QualityGovernor::took(double seconds) {
  sum_ += seconds;
  if (++pictures_ < frames_per_judgement) return false;
  const double mean = sum_ / pictures_;
  pictures_ = 0;
  sum_ = 0;
  if (mean > target_) {
    fits_ = 0;
    if (level_ == 0) return false;
    --level_;
    retry_delay_ = std::min(4 * retry_delay_, max_retry_delay);
    return true;
  }
  fits_ = mean < 0.5 * target_ ? fits_ + 1 : 0;
  if (fits_ < retry_delay_ || level_ + 1 == quality_levels.size()) return false;
  fits_ = 0;
  ++level_;
  return true;
}

}  // namespace prosector
