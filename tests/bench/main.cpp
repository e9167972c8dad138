// prosector-bench: what things cost on this machine.

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

#include "common/paths.h"
#include "common/version.h"
#include "server/physics/base/freed_memory.h"
#include "tests/bench/machine.h"
#include "tests/bench/subjects.h"
#include "tests/bench/trade_case.h"

int main(int argc, char** argv) try {
  prosector::retain_freed_memory();  // as the server does
  CLI::App app("Measures what things cost on this machine.", "prosector-bench");
  app.require_subcommand(1);
  app.set_version_flag("--version", prosector::version_line("prosector-bench"));
  std::string file;
  app.add_option("--json", file, "Also write the figures to this file");
  app.fallthrough();

  prosector::SoftBenchOptions soft;
  CLI::App* soft_command =
      app.add_subcommand("soft", "A Newton iteration of one soft body, for every law and element");
  soft_command->add_option("--tets", soft.tets, "Size, about")->check(CLI::Range(6, 10000000));
  soft_command->add_option("--threads", soft.threads, "Threads")->check(CLI::Range(1, 1024));
  soft_command->add_option("--repeats", soft.repeats, "Calls of which the median is told")
      ->check(CLI::Range(1, 1000000));

  CLI::App* integrators_command = app.add_subcommand(
      "integrators", "Each integrator alone on a spring, no guard: order, limit and growth, beside theory");

  prosector::RenderBenchOptions render;
  CLI::App* render_command = app.add_subcommand(
      "render", "Frames drawn off screen: each quality, effect, size and fineness, pass by pass");
  render_command->add_option("SCENE", render.scene, "Scene file, e.g. deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  render_command->add_option("--width", render.width, "Pixels")->check(CLI::Range(16, 4096));
  render_command->add_option("--height", render.height, "Pixels")->check(CLI::Range(16, 4096));
  render_command->add_flag("--stereo", render.stereo, "Two eyes side by side, each half as wide");
  render_command->add_option("--frames", render.frames, "Frames of which the mean is told")
      ->check(CLI::Range(1, 100000));
  render_command->add_option("--pictures", render.picture_folder, "Folder for the last frames, as PNG")
      ->check(CLI::ExistingDirectory);

  prosector::BeamBenchOptions beam;
  CLI::App* beam_command =
      app.add_subcommand("beam", "The cantilever of other codes' figures: time against errors");
  beam_command->add_option("--cells", beam.cells, "Cells across; n make 24n³ tetrahedra")
      ->check(CLI::Range(1, 100));
  beam_command->add_option("--model", beam.model, "Only this model's rows");
  beam_command->add_option("--element", beam.element, "Only this element's rows");
  beam_command->add_option("--solver", beam.solver, "Only this solver's rows");
  beam_command->add_option("--threads", beam.threads, "From one thread to this many")
      ->check(CLI::Range(1, 1024));

  prosector::Beam101kBenchOptions beam101k;
  CLI::App* beam101k_command =
      app.add_subcommand("beam101k", "SOFA's published beam of 101,250 tetrahedra: steps a second");
  beam101k_command->add_option("--steps", beam101k.steps, "Steps of 0.04 s")->check(CLI::Range(1, 100000));
  beam101k_command->add_option("--solver", beam101k.solver, "Only this solver's rows");
  beam101k_command->add_option("--threads", beam101k.threads, "From one thread to this many")
      ->check(CLI::Range(1, 1024));

  prosector::PressBenchOptions press;
  CLI::App* press_command =
      app.add_subcommand("press", "An organ pressed by a ball: steps a second in contact, and their error");
  press_command->add_option("--cells", press.cells, "Cells through the organ; n make 18n³ tetrahedra")
      ->check(CLI::Range(2, 100));
  press_command->add_option("--solver", press.solver, "Only this solver's rows");
  press_command->add_option("--threads", press.threads, "From one thread to this many")
      ->check(CLI::Range(1, 1024));

  prosector::WeightBenchOptions weight;
  CLI::App* weight_command = app.add_subcommand(
      "weight", "A cube and a slab that stand and hang, up to nu 0.4999: error against cost of each element");
  weight_command->add_option("--body", weight.body, "Only this one")->check(CLI::IsMember({"cube", "slab"}));
  weight_command->add_option("--nu", weight.poisson_ratio, "Only this one");
  weight_command->add_flag("--quick", weight.quick, "Coarse: to see that it runs");

  prosector::ContactBenchOptions contact;
  CLI::App* contact_command = app.add_subcommand(
      "contact", "Force, friction, momentum and rest of what touches, beside what they should be");
  contact_command->add_flag("--quick", contact.quick, "Coarse and short: to see that it runs");
  contact_command->add_option("--case", contact.only, "Only this one")
      ->check(CLI::IsMember(prosector::contact_case_names()));
  contact_command->add_option("--svg", contact.picture_folder, "Folder for a picture of the pressed layers")
      ->check(CLI::ExistingDirectory);

  prosector::CrowdBenchOptions crowd;
  CLI::App* crowd_command = app.add_subcommand(
      "crowd", "A step while more and more people press one organ: growth, phase by phase");
  crowd_command->add_option("SCENE", crowd.scene, "Scene file, e.g. deploy/scenes/abdomen.toml")
      ->check(CLI::ExistingFile)
      ->required();
  crowd_command->add_option("--organ", crowd.organ, "Pressed (default: the one of the most tetrahedra)");
  crowd_command->add_option("--users", crowd.users, "How many press, one row each")
      ->check(CLI::Range(1, 1000));
  crowd_command->add_option("--hands", crowd.hands, "Of each user")->check(CLI::Range(1, 2));
  crowd_command->add_option("--depth", crowd.depth, "How far in middle fingertips are aimed, m")
      ->check(CLI::Range(0., 0.1));
  crowd_command->add_option("--ticks", crowd.ticks, "Measured for each row")->check(CLI::Range(1, 100000));
  crowd_command->add_option("--threads", crowd.threads, "Of the simulation")->check(CLI::Range(1, 1024));
  crowd_command->add_option("--seed", crowd.seed, "Of the places that are pressed");

  prosector::RefineBenchOptions refine;
  CLI::App* refine_command = app.add_subcommand(
      "refine", "A ball pressed into tissue whose elements are smaller where it presses: force and cost");
  refine_command->add_flag("--quick", refine.quick, "Two rows: to see that it runs");
  refine_command->add_option("--body", refine.only, "Only this one")
      ->check(CLI::IsMember({"layer", "organ", "liver"}));
  refine_command->add_option("--contact", refine.contact, "The body's")
      ->check(CLI::IsMember({"vertices", "surface"}));
  refine_command->add_option("--threads", refine.threads, "Of the simulation")->check(CLI::Range(1, 1024));
  refine_command->add_option("--svg", refine.picture_folder, "Folder for a picture of each body")
      ->check(CLI::ExistingDirectory);

  prosector::ReferenceBenchOptions references;
  CLI::App* references_command = app.add_subcommand(
      "references", "What trade's bodies by their weight and under a ball are judged by, on finer meshes");
  references_command->add_flag("--quick", references.quick, "The coarsest mesh of each: to see that it runs");
  references_command->add_option("--case", references.only, "Only this one")
      ->check(CLI::IsMember({"cube", "slab", "hang", "press", "organ", "liver"}));

  prosector::CutBenchOptions cut;
  CLI::App* cut_command = app.add_subcommand("cut", "Ticks that cut an organ beside ticks that don't");
  cut_command->add_flag("--quick", cut.quick, "One coarse organ: to see that it runs");
  cut_command->add_option("--cell", cut.cell, "Only an organ of this cell size, m")
      ->check(CLI::Range(0.004, 0.1));
  cut_command->add_option("--stroke", cut.only, "Only this one")
      ->check(CLI::IsMember(prosector::cut_stroke_names()));
  cut_command->add_flag("--sheets", cut.sheets, "Only the sheets");
  cut_command->add_option("--model", cut.model, "The organ's (default: a scene's)");
  cut_command->add_option("--element", cut.element, "The organ's (default: a scene's)");
  cut_command->add_option("--solver", cut.solver, "The organ's (default: a scene's)");
  cut_command->add_flag("--self-contact", cut.self_contact, "The organ meets itself");
  cut_command->add_option("--threads", cut.threads, "Of the simulation")->check(CLI::Range(1, 1024));

  prosector::TradeBenchOptions trade;
  CLI::App* trade_command =
      app.add_subcommand("trade", "Error against cost of every way to model tissue, and what to choose");
  trade_command->add_flag("--quick", trade.quick, "Fewer resolutions and steps");
  trade_command->add_option("--case", trade.only, "Only this one")
      ->check(CLI::IsMember(prosector::trade_case_names()));
  trade_command->add_option("--model", trade.model, "Only this one, bullet_… included");
  trade_command->add_option("--svg", trade.picture_folder, "Folder for a picture of each case")
      ->check(CLI::ExistingDirectory);
  trade_command->add_option("--from", trade.from, "Measure nothing: tell what these reports' rows amount to")
      ->check(CLI::ExistingFile);
  trade_command->add_option("--limit", trade.limit_ms, "CPU ms that one run may take")
      ->check(CLI::Range(1., 1e9));

  prosector::StabilityBenchOptions stability;
  CLI::App* stability_command =
      app.add_subcommand("stability", "Extreme steps, materials, meshes, starts and inputs over every rung");
  stability_command->add_option("--model", stability.model, "Only this one");
  stability_command->add_option("--extreme", stability.extreme, "Only this one")
      ->check(CLI::IsMember(prosector::extreme_names()));
  stability_command->add_flag("--quick", stability.quick,
                              "Only extremes of each kind that take a blink: two minutes");
  stability_command->add_option("--svg", stability.picture_folder, "Folder for a picture of the map")
      ->check(CLI::ExistingDirectory);
  stability_command
      ->add_option("--limit", stability.limit_ms, "CPU ms that one rung may take for one extreme")
      ->check(CLI::Range(1., 1e9));

  prosector::NeedBenchOptions need;
  const std::string cache = prosector::default_cache_dir().string();
  need.cache = cache;
  CLI::App* need_command = app.add_subcommand(
      "need", "What each soft body of a scene can have at what price, and what it promises");
  need_command->add_option("SCENE", need.scene, "Scene file")->check(CLI::ExistingFile)->required();
  need_command->add_option("--body", need.body, "Only this one");
  need_command->add_option("--cache", need.cache, "Folder of tables, meshes and trials")
      ->capture_default_str();
  need_command->add_option("--data", need.data, "Folder of what the scene names (may be repeated)");
  need_command->add_flag("--verbose", need.verbose, "Also say what is tried");

  prosector::PromiseBenchOptions promise;
  promise.cache = cache;
  CLI::App* promise_command = app.add_subcommand(
      "promise",
      "Random bodies that ask for accuracy: what is promised, against finer references and other acts");
  promise_command->add_option("--cases", promise.cases, "How many")->check(CLI::Range(1, 100000));
  promise_command->add_option("--seed", promise.seed, "Of the bodies drawn");
  promise_command->add_option("--cache", promise.cache, "Folder of tables and trials")->capture_default_str();
  promise_command->add_option("--data", promise.data,
                              "Folder of liver.inr.gz; without it shapes stand for it");
  promise_command->add_flag("--verbose", promise.verbose, "Also say what is tried");
  promise_command->add_option("--reference", promise.finest_reference, "Tetrahedra of the reference, at most")
      ->check(CLI::Range(1000, 1000000));

  prosector::FeltBenchOptions felt;
  CLI::App* felt_command = app.add_subcommand(
      "felt", "What people felt in a recorded session, against finer models of what they pressed");
  felt_command->add_option("JOURNAL", felt.journal, "Journal of the session")
      ->check(CLI::ExistingFile)
      ->required();
  felt_command->add_option("--scene", felt.scene, "Scene file to run it in, in place of its own")
      ->check(CLI::ExistingFile);
  felt_command->add_option("--body", felt.body, "Soft body that was pressed")->capture_default_str();
  felt_command->add_option("--cell", felt.cells, "Size of a finer model's elements, m (may be repeated)")
      ->check(CLI::Range(1e-3, 1.))
      ->capture_default_str();
  felt_command->add_option("--threads", felt.threads)->check(CLI::Range(1, 256))->capture_default_str();

  prosector::EstimateBenchOptions estimate;
  CLI::App* estimate_command =
      app.add_subcommand("estimate", "What bodies tell of their own error against the error that they have");
  estimate_command->add_option("--case", estimate.only, "Only this one")
      ->check(CLI::IsMember({"beam", "cube", "slab", "layer", "liver"}));
  estimate_command
      ->add_option("--scene", estimate.scene, "Also what telling costs while two hands press its organ")
      ->check(CLI::ExistingFile);
  estimate_command->add_option("--svg", estimate.picture_folder, "Folder for a picture")
      ->check(CLI::ExistingDirectory);
  estimate_command->add_flag("--quick", estimate.quick, "One coarse case");

  prosector::ScalingBenchOptions scaling;
  CLI::App* scaling_command = app.add_subcommand("scaling", "Time of a frame against elements and threads");
  scaling_command->add_option("--model", scaling.model, "Only this one");
  scaling_command->add_option("--solver", scaling.solver, "Only this one");
  scaling_command->add_option("--max", scaling.max_tets, "Tetrahedra of the finest mesh")
      ->check(CLI::Range(100., 1e7));
  scaling_command->add_option("--threads", scaling.threads, "1, 2, 4 … up to this many")
      ->check(CLI::Range(1, 1024));
  scaling_command
      ->add_option("--limit", scaling.limit_ms, "CPU ms of a frame after which no finer mesh is tried")
      ->check(CLI::Range(1., 1e9));

  prosector::CollisionBenchOptions collision;
  CLI::App* collision_command =
      app.add_subcommand("collision", "Collision detection at every fidelity: cost, errors, growth");
  collision_command->add_option("--pairs", collision.pairs, "Random poses of each shape")
      ->check(CLI::Range(10, 1000000));
  collision_command->add_option("--ticks", collision.ticks, "Of which the median is told")
      ->check(CLI::Range(1, 10000));
  collision_command->add_option("--bodies", collision.max_bodies, "Of the largest scene")
      ->check(CLI::Range(100, 1000000));
  collision_command->add_option("--triangles", collision.max_triangles, "Of the finest surface")
      ->check(CLI::Range(128, 10000000));
  collision_command->add_option("--svg", collision.picture_folder, "Folder for a picture")
      ->check(CLI::ExistingDirectory);
  collision_command
      ->add_option("--limit", collision.limit_ms, "CPU ms of a tick after which no larger scene is tried")
      ->check(CLI::Range(1., 1e9));

  prosector::HapticsBenchOptions haptics;
  CLI::App* haptics_command = app.add_subcommand(
      "haptics", "What a hand feels with an arm over a network: stable stiffness, felt stiffness, energy");
  haptics_command->add_flag("--quick", haptics.quick, "Coarse: to see that it runs");
  haptics_command->add_option("--svg", haptics.picture_folder, "Folder for two pictures")
      ->check(CLI::ExistingDirectory);

  prosector::CameraBenchOptions camera;
  CLI::App* camera_command = app.add_subcommand(
      "camera",
      "Printed boards and a face before a synthetic camera: how far off, how often found, how dearly");
  camera_command->add_flag("--quick", camera.quick, "Few places: to see that it runs");
  camera_command->add_option("--page", camera.page, "A picture that is measured as a board, too")
      ->check(CLI::ExistingFile);
  camera_command->add_option("--svg", camera.picture_folder, "Folder for two pictures")
      ->check(CLI::ExistingDirectory);

  prosector::HandsBenchOptions hands;
  CLI::App* hands_command = app.add_subcommand(
      "hands", "Bare hands before synthetic cameras: what is found, how far off, how dearly");
  hands_command->add_flag("--quick", hands.quick, "Few pictures: to see that it runs");
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
