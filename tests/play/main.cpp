// prosector-play: people play at random in scenes, and the organs are judged when they have left.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/error.h"
#include "common/former_option_name.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/calibration/choose_scene.h"
#include "server/session/journal/journal_reader.h"
#include "tests/play/play.h"

namespace prosector::test {
namespace {

struct Options {
  std::vector<std::string> scenes;
  std::string watch, json, model, element;
  unsigned seed = 1;
  int seeds = 1, people = 2, bouts = 1, threads = 1;
  double bout = 8, rest = 5;
  bool tell = false, saves = false;
  std::uint64_t from = 0, to = 1ull << 40, every = 30;
};

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

CompileOptions sources(const Options& options) {
  CompileOptions compile;
  compile.threads = options.threads;
  compile.data_dirs = {default_data_dir()};
  compile.cache_dir = default_cache_dir();
  return compile;
}

/// Runs a journal again and says now and then how its organs are.
int watch(const Options& options) {
  const JournalReader journal(options.watch);
  SceneDesc scene = parse_scene(journal.header().scene_text, journal.header().scene_file);
  adopt(journal.header().choices, scene);
  Simulation simulation(scene, sources(options));
  const Judge judge(simulation);
  journal.for_each_tick(0, [&](const JournalTick& tick) {
    const StepReport& report = simulation.step(tick.input.input);
    if (tick.rebuilt) simulation.checkpoint();
    if (tick.tick > options.to) return false;
    if (tick.tick < options.from || tick.tick % options.every != 0) return true;
    const Finding now = judge.look(simulation);
    std::string notes;
    for (const BodyReport& row : report.bodies)
      if (!row.note.empty()) notes += fmt::format("; {}: {}", row.body, row.note);
    say(fmt::format("{:5} volume {:.3f} … {:.3f}, overlap {:.2f} mm, inverted {:.3f}, {:.1f} ms, {} {}",
                    tick.tick, now.least_volume, now.most_volume, 1e3 * now.overlap, now.inverted,
                    1e3 * report.total_seconds, now.where, notes));
    return true;
  });
  return 0;
}

void put_rung(const Options& options, SceneDesc& scene) {
  for (SoftDesc& soft : scene.soft) {
    if (!soft.geometry.is_solid()) continue;  // few models are for these
    if (!options.model.empty()) soft.configuration.model = options.model;
    if (!options.element.empty()) soft.configuration.element = options.element;
    if (!options.model.empty()) soft.choice.accuracy = soft.choice.budget = {};
  }
}

nlohmann::json to_json(const PlayFigures& f) {
  return {{"seconds", f.seconds},
          {"bouts", f.bouts},
          {"bad", f.bad},
          {"acts", f.acts},
          {"resets", f.resets},
          {"recovering_ticks", f.recoveries},
          {"least_volume", f.least_volume},
          {"most_volume", f.most_volume},
          {"overlap_mm", 1e3 * f.overlap},
          {"recovery_s", f.recovery},
          {"slowest_step_ms", f.step_ms},
          {"rest_step_ms", f.rest_ms},
          {"bad_saves", f.bad_saves},
          {"found", f.found}};
}

int run(const Options& options) {
  if (!options.watch.empty()) return watch(options);
  PlayFigures all;
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& file : options.scenes)
    for (int k = 0; k < options.seeds; ++k) {
      SceneDesc scene = load_scene(file);
      put_rung(options, scene);
      Simulation simulation(scene, sources(options));
      std::optional<SaveCheck> saves;
      if (options.saves) saves.emplace(scene, sources(options));
      const PlayOptions how{.seed = options.seed + static_cast<unsigned>(k),
                            .people = options.people,
                            .bouts = options.bouts,
                            .bout = options.bout,
                            .rest = options.rest,
                            .tell = options.tell,
                            .bounds = {},
                            .saves = saves ? &*saves : nullptr};
      const PlayFigures one = play(simulation, how, say);
      say(fmt::format(
          "{} seed {}: {:.0f} s, {} acts, {} of {} bouts bad; volume {:.3f} … {:.3f}, overlap {:.2f} mm, "
          "in bounds after {:.2f} s, {} resets, slowest step {:.0f} ms, at rest {:.2f} ms",
          scene.name, how.seed, one.seconds, one.acts, one.bad, one.bouts, one.least_volume, one.most_volume,
          1e3 * one.overlap, one.recovery, one.resets, one.step_ms, one.rest_ms));
      nlohmann::json row = to_json(one);
      row["scene"] = scene.name;
      row["seed"] = how.seed;
      rows.push_back(row);
      add(all, one);
    }
  if (!options.json.empty())
    std::ofstream(options.json) << nlohmann::json{{"all", to_json(all)}, {"runs", rows}}.dump(1);
  return all.bad > 0 || all.bad_saves > 0 ? 1 : 0;
}

}  // namespace
}  // namespace prosector::test

int main(int argc, char** argv) {
  using namespace prosector::test;
  Options options;
  CLI::App app("Simulated users play at random in scenes; then the organs are checked.");
  app.add_option("scenes", options.scenes, "Scene files");
  app.add_option("--watch", options.watch, "Re-run this journal instead, and print the organs' state");
  app.add_option("--from", options.from, "With --watch: first tick that is printed");
  app.add_option("--to", options.to, "With --watch: last tick");
  app.add_option("--every", options.every, "With --watch: ticks between two printed lines");
  app.add_option("--seed", options.seed, "Random seed of the first run");
  app.add_option("--seeds", options.seeds, "Number of runs per scene, with consecutive seeds");
  CLI::Option* users = app.add_option("--users", options.people, "Number of simulated users");
  prosector::accept_former_name(app, *users, "--people");
  app.add_option("--bouts", options.bouts, "Number of bouts per run, each of play and rest");
  app.add_option("--bout", options.bout, "Duration of play in a bout, s");
  app.add_option("--rest", options.rest, "Duration of rest in a bout, s; the organs are checked after it");
  app.add_option("--threads", options.threads, "Threads of the simulation");
  app.add_option("--model", options.model, "Model of every solid organ (default: the scene's)");
  app.add_option("--element", options.element, "Element type of every solid organ (default: the scene's)");
  app.add_flag("--saves", options.saves, "Save and restore the state after every tick, and compare");
  CLI::Option* verbose =
      app.add_flag("--verbose", options.tell, "Also print the organs' state while they rest");
  prosector::accept_former_name(app, *verbose, "--tell");
  app.add_option("--json", options.json, "File to write the figures to");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  } catch (const prosector::InputError& e) {
    fmt::print(stderr, "prosector-play: {}\n", e.what());
    return 2;
  }
}
