#include <cmath>
#include <limits>

#include "server/calibration/stopwatch.h"
#include "tests/bench/trade_case.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;           // s
constexpr std::size_t steps_to_judge = 10;  // steps after which the total time is extrapolated

}  // namespace

bool Runner::run(double seconds, const std::function<void(double)>& after) {
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(seconds / dt_)));
  for (std::size_t i = 0; i < steps; ++i) {
    const double cpu = prosector::cpu_ms(), wall = prosector::wall_ms();
    const StepFigures figures = body_.step(dt_, gravity_);
    step_cpu_ms_.push_back(prosector::cpu_ms() - cpu);
    cpu_ms_ += step_cpu_ms_.back();
    wall_ms_ += prosector::wall_ms() - wall;
    residual_ = std::max(residual_, figures.residual);
    if (figures.reported) note_ = figures.note;
    finite_ = finite_ && body_.positions().allFinite();
    if (!finite_) return false;
    after(static_cast<double>(i + 1) * dt_);
    const auto left = static_cast<double>(steps - i - 1);
    const bool foreseen = i + 1 >= steps_to_judge && cpu_ms_ + left * step_cpu_ms_.back() > limit_ms_;
    if (left > 0 && (foreseen || cpu_ms_ > limit_ms_)) return false;
  }
  return true;
}

ReportRow Runner::figures() const {
  const double steps = static_cast<double>(step_cpu_ms_.size());
  ReportRow row = {{"ms_per_frame", median(step_cpu_ms_) * frame / dt_},
                   {"ms_per_simulated_s", cpu_ms_ / (steps * dt_)},
                   {"steps_per_s", 1e3 * steps / wall_ms_},
                   {"residual", residual_},
                   {"simulated_s", steps * dt_},
                   {"finite", finite_}};
  if (!note_.empty()) row["reported"] = note_;
  return row;
}

std::vector<const TradeCase*> trade_cases() {
  return {&bend_case(),  &bend_incompressible_case(),
          &swing_case(), &free_case(),
          &heavy_case(), &cube_case(),
          &slab_case(),  &hang_case(),
          &press_case(), &organ_case()};
}

std::vector<std::string> trade_case_names() {
  std::vector<std::string> names;
  for (const TradeCase* which : trade_cases()) names.emplace_back(which->name);
  return names;
}

}  // namespace prosector
