#include "server/session/run/step_meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/assert.h"

namespace prosector {
namespace {

constexpr double smallest_ms = 1e-4;  // lower bound of bin 0
constexpr double ratio = 1.01;        // of the bounds of successive bins
constexpr std::size_t max_degraded_length = 400;

const char* problem_of(const BodyReport& body) {
  return body.reset ? "reset" : body.converged ? nullptr : "not converged";
}

}  // namespace

void DurationHistogram::add(double ms) {
  const double bin = std::log(std::max(ms, smallest_ms) / smallest_ms) / std::log(ratio);
  ++bin_[std::min(static_cast<std::size_t>(bin), bins - 1)];
  ++count_;
}

double DurationHistogram::quantile(double q) const {
  PROSECTOR_ASSERT(q >= 0 && q <= 1);
  if (count_ == 0) return 0;
  const auto rank = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  std::size_t bin = 0;
  while (bin + 1 < bins && (seen += bin_[bin]) < std::max<std::uint64_t>(rank, 1)) ++bin;
  return smallest_ms * std::pow(ratio, static_cast<double>(bin) + 0.5);
}

void StepMeter::add(const StepReport& report, bool tissue_awake, std::int64_t begun_ns,
                    std::int64_t ended_ns) {
  Tick tick{ended_ns, static_cast<double>(ended_ns - begun_ns) * 1e-6, {}, 0, {}};
  for (std::size_t p = 0; p < step_phases; ++p) tick.phase_ms[p] = report.seconds[p] * 1e3;
  for (const BodyReport& body : report.bodies) {
    tick.residual = std::max(tick.residual, body.residual);
    if (const char* what = problem_of(body)) {
      ++troubles_[body.body];
      tick.degraded.push_back(body.body + " " + what + (body.note.empty() ? "" : ": " + body.note));
    }
  }
  last_step_ = {report.kinetic_energy + report.elastic_energy + report.potential_energy, report.awake_bodies,
                report.asleep_bodies};
  all_.add(tick.ms);
  if (tissue_awake) awake_.add(tick.ms);
  if (tick.ms > dt_ * 1e3) ++late_;
  ticks_.push_back(std::move(tick));
  while (ticks_.size() > 2 && ticks_.front().ended_ns < ended_ns - 1'000'000'000) ticks_.pop_front();
}

LastSecond StepMeter::last_second() const {
  LastSecond out;
  if (ticks_.empty()) return out;
  std::vector<double> ms;
  std::set<std::string> degraded;
  for (const Tick& t : ticks_) {
    ms.push_back(t.ms);
    out.solver_residual = std::max(out.solver_residual, t.residual);
    for (std::size_t p = 0; p < step_phases; ++p)
      out.phase_ms[p] += t.phase_ms[p] / static_cast<double>(ticks_.size());
    degraded.insert(t.degraded.begin(), t.degraded.end());
  }
  std::sort(ms.begin(), ms.end());
  out.step_ms_p50 = ms[(ms.size() - 1) / 2];
  out.step_ms_p99 = ms[(ms.size() - 1) * 99 / 100];
  // Between the ends of the first and the last tick lie size − 1 ticks of simulated time.
  const double wall = static_cast<double>(ticks_.back().ended_ns - ticks_.front().ended_ns) * 1e-9;
  if (wall > 0) out.real_time_factor = static_cast<double>(ticks_.size() - 1) * dt_ / wall;
  for (const std::string& d : degraded) {
    if (out.degraded.size() + d.size() > max_degraded_length) {
      out.degraded += ", …";
      break;
    }
    out.degraded += (out.degraded.empty() ? "" : ", ") + d;
  }
  return out;
}

}  // namespace prosector
