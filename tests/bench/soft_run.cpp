#include "tests/bench/soft_run.h"

#include <tbb/global_control.h>

#include <algorithm>

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"

namespace prosector {
namespace {

template <class F>
double median_of(const std::vector<StepCost>& costs, const F& of) {
  std::vector<double> values;
  for (const StepCost& c : costs) values.push_back(of(c));
  return values.empty() ? 0 : median(std::move(values));
}

template <class F>
double mean(const std::vector<StepCost>& costs, const F& of) {
  double sum = 0;
  for (const StepCost& c : costs) sum += of(c);
  return costs.empty() ? 0 : sum / static_cast<double>(costs.size());
}

}  // namespace

double CostSummary::median_ms() const {
  return median_of(costs_, [](const StepCost& c) { return c.wall_ms; });
}
double CostSummary::cpu_ms() const {
  return median_of(costs_, [](const StepCost& c) { return c.cpu_ms; });
}
double CostSummary::newton() const {
  return mean(costs_, [](const StepCost& c) { return c.newton; });
}
double CostSummary::iterations() const {
  return mean(costs_, [](const StepCost& c) { return c.iterations; });
}
double CostSummary::worst_residual() const {
  double worst = 0;
  for (const StepCost& c : costs_) worst = std::max(worst, c.residual);
  return worst;
}

ReportRow figures(const CostSummary& cost) {
  return {{"steps_per_s", 1e3 / cost.median_ms()},     {"ms_per_frame", cost.median_ms()},
          {"cpu_ms_per_frame", cost.cpu_ms()},         {"newton_per_frame", cost.newton()},
          {"iterations_per_frame", cost.iterations()}, {"residual", cost.worst_residual()}};
}

void SolverEffort::apply_to(SoftDesc& desc) const {
  desc.configuration.solver = name;
  desc.configuration.newton_iterations = newton;
  desc.configuration.solver_iterations = iterations;
  desc.configuration.solver_tolerance = tolerance;
}

SoftRun::SoftRun(const SoftDesc& desc, const Anatomy& anatomy)
    : body_(desc, anatomy), state_(body_.initial_state()) {}

StepCost SoftRun::step(double h, const Vec3& gravity, std::vector<contact::Contact> contacts) {
  coupled::Island island;
  island.soft.push_back({0, &body_, &state_});
  island.contacts = std::move(contacts);
  coupled::weigh(island, gravity);
  const double start = wall_ms(), cpu_start = cpu_ms();
  const coupled::IslandReport report = solver_.solve(island, h);
  StepCost cost;
  cost.cpu_ms = cpu_ms() - cpu_start;
  cost.wall_ms = wall_ms() - start;
  cost.newton = report.newton_iterations;
  cost.iterations = report.solver_iterations;
  cost.residual = report.residual;
  finite_ = finite_ && report.finite;
  return cost;
}

void SoftRun::settle(double h, const Vec3& gravity, int steps) {
  double energy = 0;
  VecX before;
  for (int i = 0; i < steps; ++i) {
    before = state_.motion.x;
    step(h, gravity);
    const double now = soft::kinetic_energy(body_.node_mass(), state_.motion.v);
    if (now < energy) {
      state_.motion.v.setZero();
      state_.warm_start.setZero();
      state_.motion.has_history = false;
    }
    energy = now < energy ? 0 : now;
    if ((state_.motion.x - before).lpNorm<Eigen::Infinity>() < 1e-8) return;
  }
}

ReportRow settings(const soft::SoftBody& body, double dt) {
  const SoftDesc& desc = body.desc();
  return {{"model", desc.configuration.model},
          {"element", desc.configuration.element},
          {"integrator", desc.configuration.integrator},
          {"solver", desc.configuration.solver},
          {"newton_iterations", desc.configuration.newton_iterations},
          {"solver_iterations", desc.configuration.solver_iterations},
          {"solver_tolerance", desc.configuration.solver_tolerance},
          {"tets", body.elements()},
          {"nodes", body.nodes()},
          {"dt", dt},
          {"threads", tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)}};
}

TextTable path_table(const std::vector<Column>& more, const Column& last) {
  using enum Column::Kind;
  std::vector<Column> columns = {{text, "solver", "solver", 9},
                                 {count, "newton_iterations", "N"},
                                 {count, "solver_iterations", "max. it."},
                                 {number, "solver_tolerance", "to", 6}};
  columns.insert(columns.end(), more.begin(), more.end());
  columns.insert(columns.end(), {{count, "threads", "T"},
                                 {number, "steps_per_s", "steps/s"},
                                 {number, "ms_per_frame", "ms", 6},
                                 {number, "cpu_ms_per_frame", "cpu", 6},
                                 {number, "iterations_per_frame", "iter", 5},
                                 {number, "residual", "residual", 8},
                                 {percent, "error_mesh", "error", 8},
                                 last});
  return TextTable(columns);
}

contact::Contact node_contact(const VecX& x, Eigen::Index i, const Vec3& normal, double gap,
                              double stiffness) {
  contact::Contact c;
  c.a.kind = contact::ContactSide::Kind::soft;
  c.a.nodes = 1;
  c.a.node[0] = static_cast<std::uint32_t>(i);
  c.a.weight[0] = 1;
  c.point = x.segment<3>(3 * i);
  c.normal = normal;
  c.gap = gap;
  c.stiffness = stiffness;
  return c;
}

AttachDesc clamp_at(double x0, const Vec3& center) {
  // A sphere so large that its surface is practically a plane.
  constexpr double radius = 1e5;
  return {Vec3(x0 - radius, center.y(), center.z()), radius + 1e-4, 1e13};
}

}  // namespace prosector
