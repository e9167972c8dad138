// Step time as more users press one organ of a scene.

#include <fmt/format.h>

#include <algorithm>

#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/calibration/stopwatch.h"
#include "tests/bench/crowd.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

constexpr double settling = 0.75;  // s, for hands to arrive and contacts to form

/// Times of the measured ticks.
struct Ticks {
  std::vector<double> wall, cpu;  // ms
  std::array<std::vector<double>, step_phases> phases;
  std::vector<double> contacts, newton, solver, islands;
  int unconverged = 0;
};

double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void add(Ticks& ticks, const StepReport& report) {
  for (std::size_t p = 0; p < step_phases; ++p) ticks.phases[p].push_back(1e3 * report.seconds[p]);
  ticks.contacts.push_back(report.contacts);
  ticks.islands.push_back(report.mixed_islands);
  int newton = 0, solver = 0;
  bool converged = true;
  for (const BodyReport& body : report.bodies) {
    newton = std::max(newton, body.newton_iterations);
    solver = std::max(solver, body.solver_iterations);
    converged = converged && body.converged;
  }
  ticks.newton.push_back(newton);
  ticks.solver.push_back(solver);
  ticks.unconverged += converged ? 0 : 1;
}

Ticks run(Simulation& simulation, const Crowd& crowd, int count) {
  const double h = 1 / simulation.scene().tick_rate;
  const int begin = static_cast<int>(settling / h);
  Ticks ticks;
  for (int tick = 0; tick < begin + count; ++tick) {
    const TickInput input = crowd.act(tick, h);
    const double wall = wall_ms(), cpu = cpu_ms();
    const StepReport& report = simulation.step(input);
    if (tick < begin) continue;
    ticks.wall.push_back(wall_ms() - wall);
    ticks.cpu.push_back(cpu_ms() - cpu);
    add(ticks, report);
  }
  return ticks;
}

/// Returns the number of awake soft bodies.
std::size_t awake(const Simulation& simulation) {
  std::size_t count = 0;
  for (BodyId body = 0; body < simulation.body_count(); ++body)
    count += simulation.kind(body) == BodyKind::soft && !simulation.asleep(body) ? 1 : 0;
  return count;
}

/// Returns the sum of all hands' contact forces in the last tick, N.
double pressing(const Simulation& simulation) {
  double sum = 0;
  for (const HandState& hand : simulation.hands()) sum += hand.contact.impulse;
  return sum * simulation.scene().tick_rate;
}

ReportRow row_of(const Simulation& simulation, BodyId organ, std::size_t users, const Crowd& crowd,
                 const Ticks& ticks, const CrowdBenchOptions& options) {
  ReportRow row = {
      {"scene", simulation.scene().name},
      {"organ", simulation.name(organ)},
      {"tets", tet_count(simulation)},
      {"threads", options.threads},
      {"seed", options.seed},
      {"dt", 1 / simulation.scene().tick_rate},
      {"users", users},
      {"hands", crowd.hands()},
      {"depth", options.depth},
      {"ticks", ticks.wall.size()},
      {"awake", awake(simulation)},
      {"islands", median(ticks.islands)},
      {"contacts", median(ticks.contacts)},
      {"newton_iterations", median(ticks.newton)},
      {"solver_iterations", median(ticks.solver)},
      {"unconverged", static_cast<double>(ticks.unconverged) / static_cast<double>(ticks.wall.size())},
      {"force", pressing(simulation)},
      {"ms_p50", median(ticks.wall)},
      {"ms_p95", quantile(ticks.wall, 0.95)},
      {"cpu_ms_p50", median(ticks.cpu)}};
  for (std::size_t p = 0; p < step_phases; ++p)
    row[fmt::format("ms_{}", phase_names[p])] = median(ticks.phases[p]);
  return row;
}

TextTable table_of_crowds() {
  using enum Column::Kind;
  return TextTable({{count, "users", "users"},
                    {count, "hands", "hands"},
                    {number, "contacts", "contacts"},
                    {number, "islands", "islands"},
                    {count, "awake", "awake"},
                    {number, "force", "N"},
                    {number, "newton_iterations", "Newton"},
                    {number, "solver_iterations", "solver"},
                    {percent, "unconverged", "unsettled"},
                    {number, "ms_p50", "ms p50", 8},
                    {number, "ms_p95", "ms p95", 8},
                    {number, "cpu_ms_p50", "CPU ms", 8},
                    {number, "ms_inputs", "inputs", 7},
                    {number, "ms_broad", "broad", 7},
                    {number, "ms_narrow", "narrow", 7},
                    {number, "ms_islands", "islands", 7},
                    {number, "ms_coupled", "coupled", 7},
                    {number, "ms_rigid", "rigid", 7},
                    {number, "ms_constraints", "constraints", 7},
                    {number, "ms_report", "report", 7}});
}

}  // namespace

Report bench_crowd(const CrowdBenchOptions& options) {
  CompileOptions compile;
  compile.threads = options.threads;
  compile.data_dirs = {default_data_dir()};
  compile.cache_dir = default_cache_dir();
  const SceneDesc scene = load_scene(options.scene);
  const TextTable table = table_of_crowds();
  Report report("crowd");
  bool headed = false;
  for (const std::size_t users : options.users) {
    Simulation simulation(scene, compile);
    const BodyId organ = pressed_body(simulation, options.organ);
    if (!headed)
      fmt::print("{}: organ {} pressed, scene of {} tetrahedra\n", scene.name, simulation.name(organ),
                 tet_count(simulation));
    if (!headed) table.print_header();
    headed = true;
    const Crowd crowd(spread_places(simulation, organ, users * options.hands, options.seed), users,
                      options.hands, options.depth);
    report.add(row_of(simulation, organ, users, crowd, run(simulation, crowd, options.ticks), options));
    table.print(report.rows().back());
  }
  return report;
}

}  // namespace prosector
