// prosector-bench: command line of the benchmarks.

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "common/paths.h"
#include "common/version.h"
#include "server/physics/base/freed_memory.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "tests/bench/machine.h"
#include "tests/bench/subjects.h"
#include "tests/bench/trade_case.h"

namespace {

std::vector<std::string> model_names() {
  std::vector<std::string> out;
  for (const prosector::soft::ModelRow& row : prosector::soft::models()) out.emplace_back(row.name);
  return out;
}

}  // namespace

int main(int argc, char** argv) try {
  prosector::retain_freed_memory();  // as the server does
  CLI::App app("Measures performance and accuracy of the simulation, rendering and tracking on this machine.",
               "prosector-bench");
  app.require_subcommand(1);
  app.set_version_flag("--version", prosector::version_line("prosector-bench"));
  std::string file;
  app.add_option("--json", file, "Also write the report to this JSON file");
  app.fallthrough();

  prosector::SoftBenchOptions soft;
  CLI::App* soft_command =
      app.add_subcommand("soft", "Cost of one Newton iteration of a soft body, for every law and element");
  soft_command->add_option("--tets", soft.tets, "Approximate number of tetrahedra")
      ->check(CLI::Range(6, 10000000));
  soft_command->add_option("--threads", soft.threads, "Number of threads")->check(CLI::Range(1, 1024));
  soft_command->add_option("--repeats", soft.repeats, "Number of calls; the median is reported")
      ->check(CLI::Range(1, 1000000));

  CLI::App* integrators_command = app.add_subcommand("integrators",
                                                     "Each integrator on a spring, without energy safeguard: "
                                                     "order, stability limit and growth against theory");

  prosector::RenderBenchOptions render;
  CLI::App* render_command = app.add_subcommand(
      "render", "Off-screen frame times for each quality, effect, size and triangle count, by pass");
  render_command->add_option("SCENE", render.scene, "Scene file, e.g. deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  render_command->add_option("--width", render.width, "Width, pixels")->check(CLI::Range(16, 4096));
  render_command->add_option("--height", render.height, "Height, pixels")->check(CLI::Range(16, 4096));
  render_command->add_flag("--stereo", render.stereo, "Two eyes side by side, each half as wide");
  render_command->add_option("--frames", render.frames, "Number of frames; the mean is reported")
      ->check(CLI::Range(1, 100000));
  render_command->add_option("--pictures", render.picture_folder, "Folder for the last frames, as PNG")
      ->check(CLI::ExistingDirectory);

  prosector::BeamBenchOptions beam;
  CLI::App* beam_command =
      app.add_subcommand("beam", "Cantilever used in published results of other codes: time against error");
  beam_command->add_option("--cells", beam.cells, "Cells across; n cells give 24n³ tetrahedra")
      ->check(CLI::Range(1, 100));
  beam_command->add_option("--model", beam.model, "Only this model");
  beam_command->add_option("--element", beam.element, "Only this element");
  beam_command->add_option("--solver", beam.solver, "Only this solver");
  beam_command->add_option("--threads", beam.threads, "Run with 1 to this many threads")
      ->check(CLI::Range(1, 1024));

  prosector::Beam101kBenchOptions beam101k;
  CLI::App* beam101k_command =
      app.add_subcommand("beam101k", "SOFA's published beam of 101,250 tetrahedra: steps per second");
  beam101k_command->add_option("--steps", beam101k.steps, "Number of steps of 0.04 s")
      ->check(CLI::Range(1, 100000));
  beam101k_command->add_option("--solver", beam101k.solver, "Only this solver");
  beam101k_command->add_option("--threads", beam101k.threads, "Run with 1 to this many threads")
      ->check(CLI::Range(1, 1024));

  prosector::PressBenchOptions press;
  CLI::App* press_command =
      app.add_subcommand("press", "Organ pressed by a ball: steps per second in contact, and their error");
  press_command->add_option("--cells", press.cells, "Cells through the organ; n cells give 18n³ tetrahedra")
      ->check(CLI::Range(2, 100));
  press_command->add_option("--solver", press.solver, "Only this solver");
  press_command->add_option("--threads", press.threads, "Run with 1 to this many threads")
      ->check(CLI::Range(1, 1024));

  prosector::WeightBenchOptions weight;
  CLI::App* weight_command = app.add_subcommand(
      "weight", "Standing and hanging cube and slab, up to nu 0.4999: error against cost of each element");
  weight_command->add_option("--body", weight.body, "Only this body")->check(CLI::IsMember({"cube", "slab"}));
  weight_command->add_option("--nu", weight.poisson_ratio, "Only this Poisson's ratio");
  weight_command->add_flag("--quick", weight.quick, "Coarse smoke test");

  prosector::ContactBenchOptions contact;
  CLI::App* contact_command = app.add_subcommand(
      "contact", "Contact test suite: forces, friction, momentum and rest against reference values");
  contact_command->add_flag("--quick", contact.quick, "Coarse, short smoke test");
  contact_command->add_option("--case", contact.only, "Only this case")
      ->check(CLI::IsMember(prosector::contact_case_names()));
  contact_command->add_option("--svg", contact.picture_folder, "Folder for an SVG plot of the pressed layers")
      ->check(CLI::ExistingDirectory);

  prosector::CrowdBenchOptions crowd;
  CLI::App* crowd_command = app.add_subcommand("crowd", "Step time by phase as more users press one organ");
  crowd_command->add_option("SCENE", crowd.scene, "Scene file, e.g. deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  crowd_command->add_option("--organ", crowd.organ,
                            "Pressed organ (default: the one with the most tetrahedra)");
  crowd_command->add_option("--users", crowd.users, "Numbers of users, one row each")
      ->check(CLI::Range(1, 1000));
  crowd_command->add_option("--hands", crowd.hands, "Hands per user")->check(CLI::Range(1, 2));
  crowd_command->add_option("--depth", crowd.depth, "Target depth of the middle fingertips, m")
      ->check(CLI::Range(0., 0.1));
  crowd_command->add_option("--ticks", crowd.ticks, "Measured ticks per row")->check(CLI::Range(1, 100000));
  crowd_command->add_option("--threads", crowd.threads, "Threads of the simulation")
      ->check(CLI::Range(1, 1024));
  crowd_command->add_option("--seed", crowd.seed, "Random seed of the pressed positions");

  prosector::RefineBenchOptions refine;
  CLI::App* refine_command =
      app.add_subcommand("refine", "Ball pressed into locally refined tissue: force and cost");
  refine_command->add_flag("--quick", refine.quick, "Smoke test of two rows");
  refine_command->add_option("--body", refine.only, "Only this body")
      ->check(CLI::IsMember({"layer", "organ", "liver"}));
  refine_command->add_option("--contact", refine.contact, "Contact points of the body")
      ->check(CLI::IsMember({"vertices", "surface"}));
  refine_command->add_option("--threads", refine.threads, "Threads of the simulation")
      ->check(CLI::Range(1, 1024));
  refine_command->add_option("--svg", refine.picture_folder, "Folder for an SVG plot of each body")
      ->check(CLI::ExistingDirectory);

  prosector::ReferenceBenchOptions references;
  CLI::App* references_command = app.add_subcommand(
      "references", "Reference solutions of the cases of trade, on increasingly fine meshes");
  references_command->add_flag("--quick", references.quick, "Smoke test on the coarsest mesh of each case");
  references_command->add_option("--case", references.only, "Only this case")
      ->check(CLI::IsMember({"cube", "slab", "hang", "press", "organ", "liver"}));

  prosector::CutBenchOptions cut;
  CLI::App* cut_command = app.add_subcommand("cut", "Cost of ticks that cut an organ, and of other ticks");
  cut_command->add_flag("--quick", cut.quick, "Smoke test with one coarse organ");
  cut_command->add_option("--cell", cut.cell, "Only an organ of this cell size, m")
      ->check(CLI::Range(0.004, 0.1));
  cut_command->add_option("--stroke", cut.only, "Only this stroke")
      ->check(CLI::IsMember(prosector::cut_stroke_names()));
  cut_command->add_flag("--sheets", cut.sheets, "Only the sheets");
  cut_command->add_option("--model", cut.model, "Model of the organ (default: a scene's default)")
      ->check(CLI::IsMember(model_names()));
  cut_command->add_option("--element", cut.element, "Element of the organ (default: a scene's default)");
  cut_command->add_option("--solver", cut.solver, "Solver of the organ (default: a scene's default)");
  cut_command->add_flag("--self-contact", cut.self_contact, "Enable self-contact of the organ");
  cut_command->add_option("--threads", cut.threads, "Threads of the simulation")->check(CLI::Range(1, 1024));

  prosector::TradeBenchOptions trade;
  CLI::App* trade_command =
      app.add_subcommand("trade", "Error against cost of every model configuration, with a recommendation");
  trade_command->add_flag("--quick", trade.quick, "Fewer resolutions and steps");
  trade_command->add_option("--case", trade.only, "Only this case")
      ->check(CLI::IsMember(prosector::trade_case_names()));
  trade_command->add_option("--model", trade.model, "Only this model, including bullet_…");
  trade_command->add_option("--svg", trade.picture_folder, "Folder for an SVG plot of each case")
      ->check(CLI::ExistingDirectory);
  trade_command->add_option("--from", trade.from, "Evaluate these reports instead of measuring")
      ->check(CLI::ExistingFile);
  trade_command->add_option("--limit", trade.limit_ms, "CPU time limit of one run, ms")
      ->check(CLI::Range(1., 1e9));

  prosector::StabilityBenchOptions stability;
  CLI::App* stability_command = app.add_subcommand(
      "stability",
      "Extreme time steps, materials, meshes, initial states and inputs with every configuration");
  stability_command->add_option("--model", stability.model, "Only this model")
      ->check(CLI::IsMember(model_names()));
  stability_command->add_option("--extreme", stability.extreme, "Only this extreme")
      ->check(CLI::IsMember(prosector::extreme_names()));
  stability_command->add_flag("--quick", stability.quick,
                              "Only fast extremes of each kind, about two minutes");
  stability_command->add_option("--svg", stability.picture_folder, "Folder for an SVG plot of the verdicts")
      ->check(CLI::ExistingDirectory);
  stability_command->add_option("--from", stability.from, "Map these reports instead of measuring")
      ->check(CLI::ExistingFile);
  stability_command
      ->add_option("--limit", stability.limit_ms, "CPU time limit of one configuration under one extreme, ms")
      ->check(CLI::Range(1., 1e9));

  prosector::NeedBenchOptions need;
  const std::string cache = prosector::default_cache_dir().string();
  need.cache = cache;
  CLI::App* need_command = app.add_subcommand(
      "need", "Attainable accuracy of each soft body of a scene, its cost and the predicted error");
  need_command->add_option("SCENE", need.scene, "Scene file")->check(CLI::ExistingFile)->required();
  need_command->add_option("--body", need.body, "Only this body");
  need_command->add_option("--cache", need.cache, "Cache folder of tables, meshes and trials")
      ->capture_default_str();
  need_command->add_option("--data", need.data,
                           "Folder of data files that the scene names (may be repeated)");
  need_command->add_flag("--verbose", need.verbose, "Also print each trial");

  prosector::PromiseBenchOptions promise;
  promise.cache = cache;
  CLI::App* promise_command = app.add_subcommand(
      "promise", "Predicted accuracy of random bodies against finer references and other loads");
  promise_command->add_option("--cases", promise.cases, "Number of random bodies")
      ->check(CLI::Range(1, 100000));
  promise_command->add_option("--seed", promise.seed, "Random seed");
  promise_command->add_option("--cache", promise.cache, "Cache folder of tables and trials")
      ->capture_default_str();
  promise_command->add_option("--data", promise.data,
                              "Folder of liver.inr.gz; built-in shapes replace it if missing");
  promise_command->add_flag("--verbose", promise.verbose, "Also print each trial");
  promise_command
      ->add_option("--reference", promise.finest_reference, "Maximum number of tetrahedra of the reference")
      ->check(CLI::Range(1000, 1000000));

  prosector::FeltBenchOptions felt;
  CLI::App* felt_command = app.add_subcommand(
      "felt", "Contact forces of a recorded session against finer models of the pressed body");
  felt_command->add_option("JOURNAL", felt.journal, "Journal of the session")
      ->check(CLI::ExistingFile)
      ->required();
  felt_command->add_option("--scene", felt.scene, "Scene file that replaces the recorded scene")
      ->check(CLI::ExistingFile);
  felt_command->add_option("--body", felt.body, "Soft body that was pressed")->capture_default_str();
  felt_command->add_option("--cell", felt.cells, "Element size of a finer model, m (may be repeated)")
      ->check(CLI::Range(1e-3, 1.))
      ->capture_default_str();
  felt_command->add_option("--threads", felt.threads)->check(CLI::Range(1, 256))->capture_default_str();

  prosector::EstimateBenchOptions estimate;
  CLI::App* estimate_command =
      app.add_subcommand("estimate", "Estimated error of soft bodies against their true error");
  estimate_command->add_option("--case", estimate.only, "Only this case")
      ->check(CLI::IsMember({"beam", "cube", "slab", "layer", "liver"}));
  estimate_command
      ->add_option("--scene", estimate.scene,
                   "Also measure the cost of the estimates while two hands press an organ of this scene")
      ->check(CLI::ExistingFile);
  estimate_command->add_option("--svg", estimate.picture_folder, "Folder for an SVG plot")
      ->check(CLI::ExistingDirectory);
  estimate_command->add_flag("--quick", estimate.quick, "Smoke test with one coarse case");

  prosector::ScalingBenchOptions scaling;
  CLI::App* scaling_command =
      app.add_subcommand("scaling", "Frame time against number of elements and threads");
  scaling_command->add_option("--model", scaling.model, "Only this model");
  scaling_command->add_option("--solver", scaling.solver, "Only this solver");
  scaling_command->add_option("--max", scaling.max_tets, "Tetrahedra of the finest mesh")
      ->check(CLI::Range(100., 1e7));
  scaling_command->add_option("--threads", scaling.threads, "Run with 1, 2, 4 … up to this many threads")
      ->check(CLI::Range(1, 1024));
  scaling_command
      ->add_option("--limit", scaling.limit_ms, "CPU time of a frame beyond which no finer mesh is run, ms")
      ->check(CLI::Range(1., 1e9));

  prosector::CollisionBenchOptions collision;
  CLI::App* collision_command =
      app.add_subcommand("collision", "Collision detection at every fidelity: cost, errors, scaling");
  collision_command->add_option("--pairs", collision.pairs, "Random poses per shape")
      ->check(CLI::Range(10, 1000000));
  collision_command->add_option("--ticks", collision.ticks, "Number of ticks; the median is reported")
      ->check(CLI::Range(1, 10000));
  collision_command->add_option("--bodies", collision.max_bodies, "Bodies of the largest scene")
      ->check(CLI::Range(100, 1000000));
  collision_command->add_option("--triangles", collision.max_triangles, "Triangles of the finest surface")
      ->check(CLI::Range(128, 10000000));
  collision_command->add_option("--svg", collision.picture_folder, "Folder for an SVG plot")
      ->check(CLI::ExistingDirectory);
  collision_command
      ->add_option("--limit", collision.limit_ms,
                   "CPU time of a tick beyond which no larger scene is run, ms")
      ->check(CLI::Range(1., 1e9));

  prosector::HapticsBenchOptions haptics;
  CLI::App* haptics_command = app.add_subcommand(
      "haptics", "Haptic rendering over a network: stable stiffness, perceived stiffness, energy");
  haptics_command->add_flag("--quick", haptics.quick, "Coarse smoke test");
  haptics_command->add_option("--svg", haptics.picture_folder, "Folder for two SVG plots")
      ->check(CLI::ExistingDirectory);

  prosector::CameraBenchOptions camera;
  CLI::App* camera_command = app.add_subcommand(
      "camera", "Printed boards and a face before a synthetic camera: errors, detection rate, CPU time");
  camera_command->add_flag("--quick", camera.quick, "Smoke test with few poses");
  camera_command->add_option("--page", camera.page, "Image that is measured as a board, too")
      ->check(CLI::ExistingFile);
  camera_command->add_option("--svg", camera.picture_folder, "Folder for two SVG plots")
      ->check(CLI::ExistingDirectory);

  prosector::HandsBenchOptions hands;
  CLI::App* hands_command =
      app.add_subcommand("hands", "Bare hands before synthetic cameras: detection rate, errors, CPU time");
  hands_command->add_flag("--quick", hands.quick, "Smoke test with few images");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) == 0) return 0;
    std::cerr << app.help();
    return 2;
  }

  std::cout << prosector::machine().dump() << std::endl;
  std::optional<prosector::Report> report;
  if (*soft_command) report = prosector::bench_soft(soft);
  if (*integrators_command) report = prosector::bench_integrators();
  if (*render_command) report = prosector::bench_render(render);
  if (*beam_command) report = prosector::bench_beam(beam);
  if (*beam101k_command) report = prosector::bench_beam101k(beam101k);
  if (*press_command) report = prosector::bench_press(press);
  if (*weight_command) report = prosector::bench_weight(weight);
  if (*contact_command) report = prosector::bench_contact(contact);
  if (*crowd_command) report = prosector::bench_crowd(crowd);
  if (*refine_command) report = prosector::bench_refine(refine);
  if (*references_command) report = prosector::bench_references(references);
  if (*cut_command) report = prosector::bench_cut(cut);
  if (*trade_command) report = prosector::bench_trade(trade);
  if (*stability_command) report = prosector::bench_stability(stability);
  if (*need_command) report = prosector::bench_need(need);
  if (*promise_command) report = prosector::bench_promise(promise);
  if (*felt_command) report = prosector::bench_felt(felt);
  if (*estimate_command) report = prosector::bench_estimate(estimate);
  if (*scaling_command) report = prosector::bench_scaling(scaling);
  if (*collision_command) report = prosector::bench_collision(collision);
  if (*haptics_command) report = prosector::bench_haptics(haptics);
  if (*camera_command) report = prosector::bench_camera(camera);
  if (*hands_command) report = prosector::bench_hands(hands);
  if (!file.empty()) report.value().write(file);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "prosector-bench: " << error.what() << "\n";
  return 1;
}
