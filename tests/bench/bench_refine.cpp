// A ball of 10 mm radius pressed into tissue (E = 5 kPa, ν = 0.45), held, and drawn along under it: a bonded
// layer of 20 mm, 2 mm deep, and an organ on a bed, 10 mm deep. Coarse, finer throughout, and finer only
// where the ball presses, beside quadratic elements that are finer still.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/embedding.h"
#include "server/calibration/stopwatch.h"
#include "server/physics/soft/soft_body.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/scenes.h"

namespace prosector {
namespace {

constexpr double radius = 0.01;  // m, of the ball
constexpr int down_ticks = 30, held_ticks = 60, drawn_ticks = 60;
constexpr int last_ticks = 10;  // of those held, in which the force is taken
constexpr double way = 0.012;   // m: that it is drawn along
constexpr double layer_height = 0.02, layer_depth = 0.002, organ_depth = 0.01;  // m
const Vec3 layer_size(0.12, layer_height, 0.12), organ_size(0.16, 0.08, 0.12);

/// A way to model the body.
struct Modelled {
  const char* name;
  double cell;  // m
  const char* element;
  double refine_cell;  // m; 0: not refined
};

constexpr Modelled layer_ways[] = {{"coarse", 0.01, "tet4", 0},
                                   {"refined", 0.01, "tet4", 0.005},
                                   {"refined twice", 0.01, "tet4", 0.0025},
                                   {"fine", 0.005, "tet4", 0},
                                   {"finer", 0.0033, "tet4", 0}};
constexpr Modelled layer_reference[] = {{"reference", 0.003, "tet10", 0},
                                        {"finer reference", 0.00225, "tet10", 0}};
constexpr Modelled organ_ways[] = {
    {"coarse", 0.016, "tet4", 0}, {"refined", 0.016, "tet4", 0.008}, {"refined twice", 0.016, "tet4", 0.004},
    {"usual", 0.012, "tet4", 0},  {"refined", 0.012, "tet4", 0.006}, {"refined twice", 0.012, "tet4", 0.003},
    {"fine", 0.008, "tet4", 0}};
constexpr Modelled organ_reference[] = {{"reference", 0.01, "tet10", 0},
                                        {"finer reference", 0.008, "tet10", 0}};

SceneDesc scene_of(const Modelled& modelled, const std::string& contact) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {test::part_body("ball", "sphere", {2 * radius, 0, 0}, {0, 1, 0})};
  scene.rigid[0].fixed = true;
  scene.rigid[0].friction = 0;
  SoftDesc& soft = scene.soft.emplace_back();
  soft.name = "tissue";
  soft.shape = "block";
  soft.element = modelled.element;
  soft.youngs_modulus = 5000;
  soft.poisson_ratio = 0.45;
  soft.cell = modelled.cell;
  soft.contact = contact;
  soft.solver = "multigrid";
  soft.damping_mass = 5;
  if (modelled.refine_cell > 0) {
    soft.refine = "touch";
    soft.refine_cell = modelled.refine_cell;
    soft.refine_reach = radius;
    soft.refine_most = 20000;
  }
  return scene;
}

/// The layer's block in cells of that size, m.
Anatomy layer_block(double cell) {
  const auto cells = [&](double size) { return static_cast<int>(std::lround(size / cell)); };
  Anatomy out =
      test::make_block(layer_size, {cells(layer_size.x()), cells(layer_size.y()), cells(layer_size.z())});
  for (auto* points : {&out.tets.positions, &out.surface.positions})
    for (Vec3& x : *points) x.y() -= layer_height / 2;
  return out;
}

/// What is refined has the surface of the mesh that it is refined to.
CompileOptions layer_options(const Modelled& modelled, int threads) {
  CompileOptions out = test::options(threads);
  out.anatomy = [=](const SoftDesc&) -> std::optional<Anatomy> {
    if (modelled.element == std::string("tet10"))
      return test::pressed_layer(layer_height, 0.0065, modelled.cell);
    Anatomy coarse = layer_block(modelled.cell);
    if (modelled.refine_cell == 0) return coarse;
    return embed(std::move(coarse.tets), layer_block(modelled.refine_cell).surface).anatomy;
  };
  return out;
}

struct Pressed {
  double force = 0;                // N, held
  double least = 1e300, most = 0;  // N, drawn along
  double ms = 0, ms_drawn = 0;     // CPU time of a tick, median
  std::size_t tets = 0;            // at most
};

/// Presses where the surface's top is at `top`, along −y.
Pressed press(Simulation& simulation, const Vec3& top, double depth) {
  Pressed out;
  std::vector<double> held, drawn;
  for (int tick = 1; tick <= down_ticks + held_ticks + drawn_ticks; ++tick) {
    const double down = std::min(1.0, tick / double{down_ticks});
    const double along = std::max(0, tick - down_ticks - held_ticks) / double{drawn_ticks};
    TickInput input;
    input.drives.push_back({0, {top + Vec3(way * along, radius - depth * down, 0), Quat::Identity()}});
    const double begin = cpu_ms();
    simulation.step(input);
    const double took = cpu_ms() - begin;
    out.tets = std::max(out.tets, simulation.tet_count());
    double force = 0;
    for (const Exchange& touch : simulation.exchanges())
      force += std::abs(touch.impulse.y()) * simulation.scene().tick_rate;
    if (tick > down_ticks + held_ticks) {
      drawn.push_back(took);
      out.least = std::min(out.least, force);
      out.most = std::max(out.most, force);
    } else if (tick > down_ticks) {
      held.push_back(took);
      if (tick > down_ticks + held_ticks - last_ticks) out.force += force / last_ticks;
    }
  }
  out.ms = median(held);
  out.ms_drawn = median(drawn);
  return out;
}

/// The highest vertex near the middle.
Vec3 top_of(const Simulation& simulation) {
  Vec3 top(0, -1e300, 0);
  for (const Vec3& x : simulation.surface(1).positions)
    if (std::hypot(x.x(), x.z()) < radius && x.y() > top.y()) top = x;
  return top;
}

Pressed press_layer(const Modelled& modelled, const RefineBenchOptions& options) {
  SceneDesc scene = scene_of(modelled, options.contact);
  constexpr double bed = 1e4;  // m: a sphere that is flat on this scale
  scene.soft[0].attach = {{{0, -bed, 0}, bed - layer_height + 1e-4, 1e13}};
  Simulation simulation(scene, layer_options(modelled, options.threads));
  return press(simulation, Vec3::Zero(), layer_depth);
}

Pressed press_organ(const Modelled& modelled, const RefineBenchOptions& options) {
  SceneDesc scene = scene_of(modelled, options.contact);
  SoftDesc& soft = scene.soft[0];
  soft.shape = "liver";
  soft.size = organ_size;
  soft.surface_cell = modelled.element == std::string("tet10") ? modelled.cell / 2 : 0.004;
  constexpr double bed = 1;  // m: radius of what it lies in
  soft.attach = {{{0, -bed - 0.02, 0}, bed, 1e10}};
  CompileOptions compile;
  compile.threads = options.threads;
  Simulation simulation(scene, compile);
  return press(simulation, top_of(simulation), organ_depth);
}

using Press = Pressed (*)(const Modelled&, const RefineBenchOptions&);

ReportRow row_of(const char* body, const Modelled& modelled, const Pressed& pressed, double right,
                 const RefineBenchOptions& options) {
  return {{"body", body},
          {"way", modelled.name},
          {"element", modelled.element},
          {"contact", options.contact},
          {"threads", options.threads},
          {"cell_mm", 1e3 * modelled.cell},
          {"refine_cell_mm", 1e3 * modelled.refine_cell},
          {"tets_at_most", pressed.tets},
          {"force_mN", 1e3 * pressed.force},
          {"error_continuum", std::abs(pressed.force / right - 1)},
          {"ripple", (pressed.most - pressed.least) / (pressed.most + pressed.least)},
          {"cpu_ms_held", pressed.ms},
          {"cpu_ms_drawn", pressed.ms_drawn}};
}

}  // namespace

Report bench_refine(const RefineBenchOptions& options) {
  using enum Column::Kind;
  const TextTable table({{text, "body", "body", 6},
                         {text, "way", "way", 16},
                         {text, "element", "element", 6},
                         {number, "cell_mm", "cell, mm"},
                         {number, "refine_cell_mm", "refined, mm"},
                         {count, "tets_at_most", "tets at most"},
                         {number, "force_mN", "force, mN"},
                         {percent, "error_continuum", "error"},
                         {percent, "ripple", "drawn: ±"},
                         {number, "cpu_ms_held", "CPU ms held"},
                         {number, "cpu_ms_drawn", "CPU ms drawn"}});
  table.print_header();
  Report report("refine");
  const auto run = [&](const char* body, Press press_it, std::span<const Modelled> references,
                       std::span<const Modelled> ways) {
    if (!options.only.empty() && options.only != body) return;
    std::vector<Pressed> pressed;
    if (!options.quick)
      for (const Modelled& reference : references) pressed.push_back(press_it(reference, options));
    const double right = pressed.empty() ? std::nan("") : pressed.back().force;
    const auto tell = [&](const Modelled& modelled, const Pressed& of) {
      report.add(row_of(body, modelled, of, right, options));
      table.print(report.rows().back());
    };
    for (std::size_t i = 0; i < pressed.size(); ++i) tell(references[i], pressed[i]);
    for (const Modelled& modelled : ways.first(options.quick ? 2 : ways.size()))
      tell(modelled, press_it(modelled, options));
  };
  run("layer", press_layer, layer_reference, layer_ways);
  run("organ", press_organ, organ_reference, organ_ways);
  return report;
}

}  // namespace prosector
