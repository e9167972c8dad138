#include "tests/bench/contact_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

/// Returns the verdict. Survives: within tolerance and no reset. Degrades: a body was reset, within tolerance
/// or not. Fails: otherwise, or positions not finite.
Verdict judge(const ContactRun& run, bool right) {
  if (!run.finite()) return Verdict::fails;
  if (right) return run.resets() == 0 ? Verdict::survives : Verdict::degrades;
  return run.resets() > 0 ? Verdict::degrades : Verdict::fails;
}

std::string reason(const ContactRun& run, bool right) {
  if (!run.finite()) return "positions not finite";
  if (!run.note().empty()) return run.note();
  return right ? "" : "out of tolerance";
}

}  // namespace

ContactRun::ContactRun(const SceneDesc& scene, const CompileOptions& options)
    : simulation_(scene, options), h_(1 / scene.tick_rate) {}

const StepReport& ContactRun::step(const TickInput& input) {
  const double start = prosector::cpu_ms(), wall = wall_ms();
  const StepReport& report = simulation_.step(input);
  tick_ms_.push_back(prosector::cpu_ms() - start);
  wall_ms_.push_back(wall_ms() - wall);
  watch(report);
  return report;
}

void ContactRun::run(int ticks, const TickInput& input) {
  TickInput now = input;
  for (int i = 0; i < ticks; ++i) {
    step(now);
    now.events.clear();
  }
}

void ContactRun::watch(const StepReport& report) {
  energy_ = report.kinetic_energy + report.elastic_energy + report.potential_energy;
  highest_energy_ = ticks_ == 0 ? energy_ : std::max(highest_energy_, energy_);
  ++ticks_;
  bool lossy = false;
  for (const BodyReport& body : report.bodies) {
    lossy = lossy || body.reset || !body.converged;
    if (!body.reset) continue;
    if (resets_++ == 0) note_ = fmt::format("{}: {}", body.body, body.note);
  }
  reported_ += lossy ? 1 : 0;
  for (BodyId body = 0; body < simulation_.body_count(); ++body)
    finite_ = finite_ &&
              (simulation_.kind(body) == BodyKind::rigid ? is_finite(simulation_.rigid_state(body).pose)
                                                         : simulation_.soft_state(body).motion.x.allFinite());
}

double ContactRun::ms_per_tick() const {
  return tick_ms_.empty()
             ? 0
             : std::reduce(tick_ms_.begin(), tick_ms_.end()) / static_cast<double>(tick_ms_.size());
}

double ContactRun::median_wall_ms() const {
  return wall_ms_.empty() ? 0 : median(wall_ms_);
}

double ContactRun::quantile_ms(double share) const {
  std::vector<double> sorted = tick_ms_;
  std::sort(sorted.begin(), sorted.end());
  return sorted.empty() ? 0
                        : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

namespace {

TextTable table() {
  using enum Column::Kind;
  return TextTable({{text, "case", "case", 9},
                    {text, "setting", "setting", 46},
                    {text, "figure", "figure", 34},
                    {number, "measured", "measured", 9},
                    {number, "reference", "reference", 9},
                    {number, "tolerance", "within", 8},
                    {text, "unit", "unit", 6},
                    {number, "ms_per_tick", "ms/tick", 7},
                    {text, "verdict", "verdict", 9},
                    {text, "reason", "why"}});
}

}  // namespace

ContactRows::ContactRows(Report& report) : report_(report) {
  table().print_header();
}

void ContactRows::add(const ContactRun& run, const std::string& setting, const ContactFigure& figure,
                      ReportRow more) {
  ReportRow row = {{"case", case_},       {"setting", setting},          {"figure", figure.what},
                   {"unit", figure.unit}, {"measured", figure.measured}, {"reference", figure.reference}};
  row["tolerance"] = nullptr;
  if (figure.tolerance) {
    const bool right = std::abs(figure.measured - figure.reference) <= *figure.tolerance;
    row["tolerance"] = *figure.tolerance;
    row["verdict"] = verdict_name(judge(run, right));
    row["reason"] = reason(run, right);
  }
  row["ticks"] = run.ticks();
  row["dt"] = run.h();
  row["ms_per_tick"] = run.ms_per_tick();
  row["resets"] = run.resets();
  row["ticks_with_loss"] = run.reported();
  if (more.is_object()) row.update(more);
  report_.add(std::move(row));
  table().print(report_.rows().back());
}

Vec3 soft_momentum(const Simulation& simulation, BodyId body) {
  const VecX& mass = simulation.soft(body).node_mass();
  const VecX& v = simulation.soft_state(body).motion.v;
  return v.reshaped(3, mass.size()) * mass;
}

Vec3 rigid_momentum(const Simulation& simulation, BodyId body, double mass) {
  return mass * simulation.rigid_state(body).linear_velocity;
}

Vec3 soft_centre(const Simulation& simulation, BodyId body) {
  const VecX& x = simulation.soft_state(body).motion.x;
  return x.reshaped(3, x.size() / 3).rowwise().mean();
}

TickInput driving(BodyId body, const Pose& to) {
  TickInput input;
  input.kinematic_targets.push_back({body, to});
  return input;
}

}  // namespace prosector
