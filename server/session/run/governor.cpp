#include "server/session/run/governor.h"
#include "common/commands.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr int undone = 10;  // ticks with room that one without room cancels

}  // namespace

Governor::Governor(double tick_rate, std::map<BodyId, int> may)
    : period_(1 / tick_rate), steps_(std::move(may)) {
  for (const auto& [body, steps] : steps_) order_.insert(order_.end(), static_cast<std::size_t>(steps), body);
}

int Governor::ticks(double seconds) const {
  return std::max(1, static_cast<int>(std::lround(seconds / period_)));
}

std::optional<EffortChange> Governor::tick(double seconds, const std::map<BodyId, double>& work) {
  ++tick_;
  if (steps_.empty()) return std::nullopt;
  if (seconds > period_) ++late_;
  room_ = seconds <= room_share * period_ ? room_ + 1 : std::max(0, room_ - undone);
  const bool overload = ++judged_ >= ticks(overload_seconds) && 2 * late_ > judged_;
  if (judged_ >= ticks(overload_seconds)) late_ = judged_ = 0;
  if (overload) return step_down(work);
  if (room_ >= ticks(step_up_delay_)) return step_up();
  return std::nullopt;
}

std::optional<EffortChange> Governor::step_down(const std::map<BodyId, double>& work) {
  const auto work_of = [&](BodyId body) {
    const auto it = work.find(body);
    return it == work.end() ? 0 : it->second;
  };
  std::optional<BodyId> costliest;
  for (const auto& [body, steps] : steps_) {
    if (steps >= static_cast<int>(max_steps_down) || !(work_of(body) > 0)) continue;
    if (!costliest || work_of(body) > work_of(*costliest)) costliest = body;
  }
  if (!costliest) return std::nullopt;
  const bool in_vain =
      stepped_up_at_ && tick_ - *stepped_up_at_ < static_cast<std::uint64_t>(ticks(vain_seconds));
  step_up_delay_ = in_vain ? std::min(2 * step_up_delay_, max_step_up_delay) : room_seconds;
  order_.push_back(*costliest);
  return change(*costliest, 1);
}

std::optional<EffortChange> Governor::step_up() {
  room_ = 0;
  if (order_.empty()) return std::nullopt;
  const BodyId last = order_.back();
  order_.pop_back();
  stepped_up_at_ = tick_;
  return change(last, -1);
}

EffortChange Governor::change(BodyId body, int by) {
  late_ = judged_ = room_ = 0;
  return {body, steps_.at(body) += by};
}

}  // namespace prosector
