// A liver (from CT data if available) is pressed 10 mm deep by a ball of 10 mm radius, and stroked. Real-time
// meshes are compared with eight times the elements on the same shape.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/paths.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/stations/compile/sources.h"
#include "tests/bench/contact_run.h"
#include "tests/physics/under_ball.h"

namespace prosector {
namespace {

constexpr double ball_radius = 0.01, organ_depth = 0.01, stroke = 0.01, stroke_speed = 0.02;  // m, m/s
constexpr int organ_down = 30, organ_held = 30;                                               // ticks
constexpr double organ_cell = 0.025, organ_coarse_cell = 0.05;                                // m

SceneDesc organ_scene(double cell) {
  SoftDesc liver;
  liver.name = "liver";
  liver.geometry.volume = "liver.inr.gz";
  liver.geometry.label = 255;
  liver.pose.q = Quat(0, 1, 0, 0);
  liver.geometry.fallback = "liver";
  liver.geometry.size = {0.206, 0.149, 0.171};
  liver.configuration.model = "fem_neo_hookean";
  liver.configuration.element = "tet10";
  liver.configuration.solver = "multigrid";
  liver.configuration.solver_tolerance = 1e-2;
  liver.contact.points = ContactPoints::surface;
  liver.material.youngs_modulus = 5400;
  liver.material.damping_mass = 4;
  liver.material.damping_stiffness = 0.02;
  liver.gravity = false;
  liver.geometry.cell = cell;
  liver.geometry.surface_cell = cell / 3;
  liver.geometry.max_volume_error.value = 40;  // %: cells as large as these cut off the liver's thin edges
  return test::under_ball(liver, ball_radius, {0, 1, 0});
}

/// Divides each tetrahedron into eight, with the same surface.
Anatomy in_eight(Anatomy anatomy) {
  const soft::EdgeNodes edges = soft::add_edge_nodes(anatomy);
  anatomy.tets = soft::divided(anatomy.tets, edges);
  return anatomy;
}

Vec3 highest(const TriangleMesh& surface) {
  return *std::max_element(surface.positions.begin(), surface.positions.end(),
                           [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
}

/// Forces of a press and of stroking.
struct Felt {
  double force = 0, dent = 0;  // N; m: depth of the ball minus the compression of the contact
  double jump = 0;             // largest relative force change per tick
  std::vector<double> forces;  // N, while stroking
};

Felt feel(ContactRun& run, const Vec3& top) {
  const auto step_to = [&](double x, double depth) {
    run.step(driving(0, {top + Vec3(x, ball_radius - depth, 0), Quat::Identity()}));
  };
  for (int tick = 1; tick <= organ_down + organ_held; ++tick)
    step_to(0, organ_depth * std::min(1.0, static_cast<double>(tick) / organ_down));
  Felt felt;
  felt.force = test::pressing_force(run.simulation());
  double give = 0;  // m
  for (const Exchange& touch : run.simulation().exchanges()) give = std::max(give, touch.depth);
  felt.dent = organ_depth - give;
  double last = felt.force;
  for (double x = 0; x < stroke; x += stroke_speed * run.h()) {
    step_to(x, organ_depth);
    const double now = test::pressing_force(run.simulation());
    felt.jump = std::max(felt.jump, std::abs(now / last - 1));
    felt.forces.push_back(now);
    last = now;
  }
  return felt;
}

ContactRun pressed(SceneDesc scene, const Anatomy& anatomy) {
  scene.rigid[0].pose.p = highest(anatomy.surface) + Vec3(0, ball_radius + 1e-4, 0);
  CompileOptions options;
  options.threads = 2;
  options.anatomy = [&](const SoftDesc&) -> std::optional<Anatomy> { return anatomy; };
  return ContactRun(scene, options);
}

}  // namespace

void organ_case(ContactRows& rows, bool quick) {
  SceneDesc scene = organ_scene(quick ? organ_coarse_cell : organ_cell);
  CompileOptions options;
  options.data_dirs = {default_data_dir()};
  const Anatomy anatomy = soft_anatomy(scene.soft[0], scene, options);
  double low = anatomy.tets.positions.front().y();
  for (const Vec3& x : anatomy.tets.positions) low = std::min(low, x.y());
  constexpr double flat = 1000, foot = 0.02;  // m: a bed holds the lowest 2 cm
  scene.soft[0].attach = {{{0, low + foot - flat, 0}, flat, 1e9}};
  const Vec3 top = highest(anatomy.surface);
  ContactRun reference = pressed(scene, in_eight(anatomy));
  const Felt truth = feel(reference, top);
  for (const char* element : {"tet10", "tet4"}) {
    scene.soft[0].configuration.element = element;
    ContactRun run = pressed(scene, anatomy);
    const Felt felt = feel(run, top);
    double off = 0;
    for (std::size_t i = 0; i < felt.forces.size(); ++i)
      off = std::max(off, std::abs(felt.forces[i] / truth.forces[i] - 1));
    const bool asked = scene.soft[0].configuration.element == "tet10";
    const auto within = [&](double tolerance) { return asked ? std::optional(tolerance) : std::nullopt; };
    const std::string setting = fmt::format("liver pressed 10 mm deep, {}", element);
    const ReportRow more = {{"element", element},
                            {"tets", tet_count(run.simulation())},
                            {"reference_tets", tet_count(reference.simulation())},
                            {"force_N", felt.force},
                            {"reference_force_N", truth.force},
                            {"wall_ms", run.median_wall_ms()},
                            {"reference_cpu_ms", reference.median_ms()}};
    rows.add(run, setting, {"force over reference force", "1", felt.force / truth.force, 1, within(0.05)},
             more);
    rows.add(run, setting,
             {"indentation over reference indentation", "1", felt.dent / truth.dent, 1, within(0.05)}, more);
    rows.add(run, setting, {"stroking: largest force error", "1", off, 0, within(0.05)}, more);
    rows.add(run, setting, {"stroking: largest change per tick", "1", felt.jump, 0, within(0.02)}, more);
    rows.add(run, setting, {"median CPU time per tick", "ms", run.median_ms(), 0, std::nullopt}, more);
    rows.add(run, setting,
             {"median wall time per tick", "ms", run.median_wall_ms(), 0, within(1e3 * run.h())}, more);
    if (quick) return;
  }
}

}  // namespace prosector
