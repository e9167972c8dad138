#include "drivers/gamepad/rumble.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double full_force = 8;                        // N: force at which the strong motor saturates
constexpr double full_force_rate = 30;                  // N/s: rate at which the weak motor saturates
constexpr double smoothing = 0.03, burst_decay = 0.12;  // s: time constants of the force filter and of the
                                                        // burst decay
constexpr double min_level_change = 0.02;  // of a motor's range: smaller levels and changes are not
                                           // sent
constexpr double resend_interval = 0.25;   // s: resend interval, since motors stop without updates

}  // namespace

bool Rumble::follow(double force, double dt) {
  if (!(dt > 0) || !std::isfinite(force)) return true;
  const double before = force_;
  force_ += (1 - std::exp(-dt / smoothing)) * (std::abs(force) - force_);
  burst_ = std::max(burst_ * std::exp(-dt / burst_decay),
                    std::min(1., std::abs(force_ - before) / dt / full_force_rate));
  const double strong = std::min(1., force_ / full_force);
  const auto level = [](double share) { return share < min_level_change ? 0 : share; };
  const bool changed =
      std::abs(strong - strong_) > min_level_change || std::abs(burst_ - weak_) > min_level_change;
  const bool runs = level(strong_) > 0 || level(weak_) > 0;
  since_ += dt;
  if (!changed && !(runs && since_ > resend_interval)) return true;
  strong_ = level(strong);
  weak_ = level(burst_);
  since_ = 0;
  return motors_->set(strong_, weak_);
}

}  // namespace prosector
