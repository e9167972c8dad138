#include "server/session/run/body_meter.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

constexpr double report_rate = 2;  // Hz: rate of reports

/// Returns how many substeps the body's method needs now for a tick of h s; 0: it is solved in one step.
std::uint32_t substeps_to_come(const Simulation& simulation, BodyId body, double h) {
  const soft::Substepper* own = simulation.soft(body).substepper();
  if (own == nullptr) return 0;
  const double needed = own->needed(h, simulation.soft_state(body));
  return needed <= own->allowed() ? static_cast<std::uint32_t>(needed) : 0;
}

}  // namespace

std::map<std::string, Prospect> expectations_of(const std::vector<Choice>& choices) {
  std::map<std::string, Prospect> out;
  for (const Choice& c : choices) out[c.body] = c.expected;
  return out;
}

BodyMeter::BodyMeter(const Simulation& simulation, const std::map<std::string, Prospect>& expected)
    : tick_seconds_(1 / simulation.scene().tick_rate),
      period_(std::max<std::uint64_t>(
          1, static_cast<std::uint64_t>(std::lround(simulation.scene().tick_rate / report_rate)))),
      estimates_(simulation) {
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (simulation.kind(b) != BodyKind::soft) continue;
    const auto it = expected.find(simulation.name(b));
    add_body(simulation, b, it == expected.end() ? nullptr : &it->second);
  }
}

void BodyMeter::add_body(const Simulation& simulation, BodyId body, const Prospect* expected) {
  id_of_.try_emplace(simulation.name(body), body);
  BodyStatus& status = sums_[body].status;
  status.body = body;
  status.substeps = substeps_to_come(simulation, body, tick_seconds_);
  status.step = tick_seconds_ / std::max(1u, status.substeps);
  if (expected != nullptr) status.expected_ms = expected->ms;
  newest_[body] = status;
}

void BodyMeter::set_prices(BodyId body, std::vector<Price> prices) {
  const auto it = sums_.find(body);
  if (it == sums_.end()) return;
  it->second.status.prices = std::move(prices);
  it->second.reported = false;
}

void BodyMeter::add(const Simulation& simulation, const StepReport& report) {
  estimates_.follow(simulation, report);
  for (const auto& [body, sum] : sums_) {
    const LiveEstimate* estimate = estimates_.newest(body);
    if (estimate == nullptr || estimate->press_error < 0) continue;
    if (MeteredPress& press = presses_[body]; estimate->press_force > press.force)
      press = {estimate->press_force, estimate->press_error};
  }
  for (const BodyReport& row : report.bodies) {
    const auto id = id_of_.find(row.body);
    if (id == id_of_.end()) continue;
    Sum& sum = sums_.at(id->second);
    ++sum.ticks;
    sum.newton_iterations += row.newton_iterations;
    sum.solver_iterations += row.solver_iterations;
    BodyStatus& s = sum.status;
    s.converged = s.converged && row.converged && !row.reset;
    s.step = row.substep > 0 ? row.substep : tick_seconds_;
    s.substeps = row.substep > 0 ? static_cast<std::uint32_t>(std::lround(tick_seconds_ / row.substep)) : 0;
    if (std::isfinite(row.residual)) s.residual = std::max(s.residual, row.residual);
    s.correction = std::max(s.correction, row.last_step);
  }
}

std::vector<BodyStatus> BodyMeter::take(const Simulation& simulation) {
  std::vector<BodyStatus> out;
  const bool due = simulation.time().tick % period_ == 0;
  for (auto& [body, sum] : sums_) {
    const bool fell_asleep = simulation.asleep(body) && !sum.was_asleep;
    if (sum.reported && !fell_asleep && !(due && (sum.ticks > 0 || news_of_rest(body, sum)))) continue;
    out.push_back(close(sum, simulation));
    newest_[body] = out.back();
  }
  return out;
}

/// Returns whether there is an estimate that was not reported yet.
bool BodyMeter::news_of_rest(BodyId body, const Sum& sum) const {
  const LiveEstimate* estimate = estimates_.newest(body);
  return estimate != nullptr && estimate->tick != sum.reported_estimate;
}

double BodyMeter::worst_error() const {
  double worst = -1;
  for (const auto& [body, sum] : sums_)
    if (const LiveEstimate* estimate = estimates_.newest(body)) worst = std::max(worst, estimate->error);
  return worst;
}

/// Returns the means since the last report, and resets them.
BodyStatus BodyMeter::close(Sum& sum, const Simulation& simulation) const {
  BodyStatus out = sum.status;
  out.time = simulation.time();
  out.asleep = simulation.asleep(out.body);
  out.stepped_down = static_cast<std::uint32_t>(simulation.soft_state(out.body).steps_down);
  if (const LiveEstimate* estimate = estimates_.newest(out.body)) {
    out.error = estimate->error;
    out.parts = estimate->parts;
    out.press_error = estimate->press_error;
    out.error_map = estimate->map;
    sum.reported_estimate = estimate->tick;
  }
  const double ticks = std::max<std::uint32_t>(1, sum.ticks);
  out.newton_iterations = sum.newton_iterations / ticks;
  out.solver_iterations = sum.solver_iterations / ticks;
  sum.status.converged = true;
  sum.status.residual = sum.status.correction = 0;
  sum.ticks = 0;
  sum.newton_iterations = sum.solver_iterations = 0;
  sum.was_asleep = out.asleep;
  sum.reported = true;
  return out;
}

}  // namespace prosector
