// Contact forces of a recorded session against those of finer models of the organ.
//
// The journal's inputs are re-run on each model. Forces are means over the ticks in which the session's own
// model had the largest forces.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/error.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/accuracy/body_trial.h"
#include "server/calibration/choose_scene.h"
#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/journal/journal_reader.h"
#include "tests/bench/crowd.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

constexpr double pressed_hard = 0.9;  // fraction of the largest force from which ticks are evaluated
constexpr int reference_iterations =
    12;  // maximum of Newton iterations: a scene's default may be too few to converge

/// Forces, displacements and cost of a run.
struct Felt {
  std::string body;
  std::vector<double> force;   // N, total of all hands on the body, per tick
  std::vector<double> moved;   // m, largest displacement, per tick
  std::size_t tets = 0;        // largest number
  double ms = 0, ms_most = 0;  // mean and largest CPU time of ticks with contact
};

double force_on(const Simulation& simulation, BodyId body) {
  double force = 0;
  for (const HandState& hand : simulation.hands())
    if (hand.contact.touching && hand.contact.body == body) force += hand.contact.force.norm();
  return force;
}

Felt run(const JournalReader& journal, const SceneDesc& scene, const FeltBenchOptions& options) {
  CompileOptions compile;
  compile.threads = options.threads;
  compile.data_dirs = {default_data_dir()};
  compile.cache_dir = default_cache_dir();
  Simulation simulation(scene, compile);
  const BodyId body = pressed_body(simulation, options.body);
  Felt out;
  out.body = simulation.name(body);
  journal.for_each_tick(0, [&](const JournalTick& tick) {
    const double begun = cpu_ms();
    simulation.step(tick.input.input);
    out.force.push_back(force_on(simulation, body));
    out.moved.push_back(simulation.max_displacement(body));
    out.tets = std::max(out.tets, simulation.soft(body).elements());
    if (out.force.back() > 0) {
      const double took = cpu_ms() - begun;
      out.ms += took;
      out.ms_most = std::max(out.ms_most, took);
    }
    return true;
  });
  out.ms /= std::max<double>(
      1, static_cast<double>(std::ranges::count_if(out.force, [](double f) { return f > 0; })));
  return out;
}

/// Returns the mean over the ticks in which `own` had the largest forces.
double while_pressed(const std::vector<double>& values, const std::vector<double>& own) {
  const double hard = pressed_hard * *std::ranges::max_element(own);
  double sum = 0, ticks = 0;
  for (std::size_t tick = 0; tick < own.size(); ++tick) {
    if (own[tick] < hard) continue;
    sum += values[tick];
    ++ticks;
  }
  return sum / ticks;
}

}  // namespace

Report bench_felt(const FeltBenchOptions& options) {
  using enum Column::Kind;
  const JournalReader journal(options.journal);
  if (!journal.header().beginning.empty())
    throw InputError(fmt::format(
        "{}: starts with a saved state; expected a journal that starts with its scene", options.journal));
  SceneDesc scene = options.scene.empty()
                        ? parse_scene(journal.header().scene_text, journal.header().scene_file)
                        : load_scene(options.scene);
  adopt(journal.header().choices, scene);

  Report report("felt");
  const TextTable table({{text, "model", "model", 16},
                         {text, "element", "element", 7},
                         {number, "cell_mm", "cell mm", 7},
                         {count, "tets", "tets", 6},
                         {number, "force_N", "force N", 8},
                         {percent, "force_off", "difference", 11},
                         {number, "moved_mm", "displ. mm", 8},
                         {number, "ms", "ms per tick", 9},
                         {number, "ms_most", "max. ms", 8}});
  table.print_header();
  const Felt own = run(journal, scene, options);
  if (own.force.empty() || *std::ranges::max_element(own.force) <= 0)
    throw InputError(fmt::format("{}: no hand pressed \"{}\" in this session", options.journal, own.body));
  const double own_force = while_pressed(own.force, own.force);
  const auto tell = [&](const SoftDesc& desc, const Felt& felt) {
    const double force = while_pressed(felt.force, own.force);
    report.add({{"model", desc.configuration.model},
                {"element", desc.configuration.element},
                {"cell_mm", 1e3 * desc.geometry.cell},
                {"tets", felt.tets},
                {"force_N", force},
                {"force_off", own_force / force - 1},
                {"moved_mm", 1e3 * while_pressed(felt.moved, own.force)},
                {"ms", felt.ms},
                {"ms_most", felt.ms_most}});
    table.print(report.rows().back());
  };
  SoftDesc& desc = *std::ranges::find(scene.soft, own.body, &SoftDesc::name);
  tell(desc, own);
  desc.configuration.model = tissue_law;
  desc.refinement.at = SoftDesc().refinement.at;
  desc.configuration.element = "tet10";
  desc.contact.points = ContactPoints::surface;
  desc.configuration.newton_iterations = std::max(desc.configuration.newton_iterations, reference_iterations);
  for (const double cell : options.cells) {
    desc.geometry.cell = cell;
    tell(desc, run(journal, scene, options));
  }
  return report;
}

}  // namespace prosector
