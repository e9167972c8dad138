#include "drivers/rumble.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double full_force = 8;                 // N: at which the strong motor does all it can
constexpr double full_change = 30;               // N/s: the same for the weak one
constexpr double smoothing = 0.03, ebbs = 0.12;  // s: of the force; in which a burst ebbs away
constexpr double noticed = 0.02;                 // of a motor's range: less isn't told
constexpr double told_again = 0.25;              // s: motors stop by themselves if nothing comes

}  // namespace

bool Rumble::follow(double force, double dt) {
  if (!(dt > 0) || !std::isfinite(force)) return true;
  const double before = force_;
  force_ += (1 - std::exp(-dt / smoothing)) * (std::abs(force) - force_);
  burst_ =
      std::max(burst_ * std::exp(-dt / ebbs), std::min(1., std::abs(force_ - before) / dt / full_change));
  const double strong = std::min(1., force_ / full_force);
  const auto level = [](double share) { return share < noticed ? 0 : share; };
  const bool changed = std::abs(strong - strong_) > noticed || std::abs(burst_ - weak_) > noticed;
  const bool runs = level(strong_) > 0 || level(weak_) > 0;
  since_ += dt;
  if (!changed && !(runs && since_ > told_again)) return true;
  strong_ = level(strong);
  weak_ = level(burst_);
  since_ = 0;
  return motors_->set(strong_, weak_);
}

}  // namespace prosector
