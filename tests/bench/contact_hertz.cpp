// A rigid ball pressed into a bonded layer, frictionless, small strain: force against the finite-layer table,
// which was computed for a ball that moves the surface vertically. Ours meets a ball, whose sides push
// outwards too: that differs by the order of a/R, times 1 − 2ν, and vanishes for flat balls and
// incompressible layers.

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "common/body_messages.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/contact_run.h"
#include "tests/bench/finite_layer.h"
#include "tests/physics/pressed_layer.h"

namespace prosector {
namespace {

constexpr int most_ticks = 9;     // of 1 s: inertia is nothing, normals follow the surface …
constexpr double settled = 3e-3;  // … until two ticks agree so well

using Press = LayerPress;
constexpr auto& presses = layer_presses;

/// The table is for small slopes. The ball's second order is that of its slope's square, where contact ends:
/// a steeper one is also judged under a flatter ball of the same radius of contact.
constexpr double most_slope = 1.0 / 3;
double slope(const Press& press) {
  return std::sqrt(press.depth / press.radius);
}

struct Mesh {
  const char* element;
  double cells;  // under the radius of contact √(R·depth)
  bool finest;
};
constexpr Mesh meshes[] = {{"tet4", 0.5, false},  {"tet4", 1, false},  {"tet4", 2, false},
                           {"tet10", 0.5, false}, {"tet10", 1, false}, {"tet10", 2, true}};

SceneDesc scene_of(const Press& press, const Mesh& mesh, double cell, double stiffness) {
  SceneDesc scene = layer_scene(press, mesh.element, cell);
  scene.tick_rate = 1;
  scene.contact_stiffness = stiffness;
  SoftDesc& layer = scene.soft[0];
  layer.damping_mass = layer.damping_stiffness = 0;
  layer.newton_iterations = 8;
  layer.solver_iterations = 500;
  layer.solver_tolerance = 1e-5;
  if (layer.element == "tet10") layer.surface_cell = cell / 2;
  return scene;
}

struct Settled {
  double force = 0, change = 1;  // N; of the last tick, over it
  std::uint32_t points = 0;      // that pressed
};

/// Holds the ball pressed in at (x, z), m, until its force is settled.
Settled settle(ContactRun& run, const Press& press, double x, double z) {
  const Pose pressed{{x, press.radius - press.depth, z}, Quat::Identity()};
  Settled out;
  for (int tick = 0; tick < most_ticks && std::abs(out.change) > settled; ++tick) {
    run.step(driving(0, pressed));
    const double last = out.force;
    out.force = 0;
    for (const Exchange& touch : run.simulation().exchanges()) {
      out.force += std::abs(touch.impulse.y()) / run.h();
      out.points = touch.points;
    }
    out.change = tick > 0 ? out.force / last - 1 : 1;
  }
  return out;
}

void press(ContactRows& rows, const Press& press, const Mesh& mesh, double stiffness,
           const std::string& setting, std::optional<double> tolerance) {
  const double contact_radius = std::sqrt(press.radius * press.depth);
  const double cell = contact_radius / mesh.cells;
  CompileOptions options;
  options.threads = 1;
  options.anatomy = [&](const SoftDesc& desc) -> std::optional<Anatomy> {
    Anatomy made = test::pressed_layer(press.height, 1.5 * contact_radius, cell);
    if (desc.element == "tet10") test::halve_surface(made);
    return made;
  };
  ContactRun run(scene_of(press, mesh, cell, stiffness), options);
  const Settled found = settle(run, press, 0, 0);
  rows.add(run, setting, {"force over the table's", "1", found.force / press.force, 1, tolerance},
           {{"element", mesh.element},
            {"cell_m", cell},
            {"cells_per_contact_radius", mesh.cells},
            {"contact_stiffness", stiffness},
            {"layer_m", press.height},
            {"depth_m", press.depth},
            {"radius_m", press.radius},
            {"poisson_ratio", press.poisson_ratio},
            {"force_N", found.force},
            {"change_of_last_tick", found.change},
            {"tets", tet_count(run.simulation())},
            {"nodes", run.simulation().soft(1).nodes()}});
}

/// Presses at places all over a cell, with contacts of a scene's default stiffness: over the area that
/// touches or, to compare, at vertices. What is felt shall not tell where these lie.
void press_all_over(ContactRows& rows, const Press& press, const Mesh& mesh, const std::string& contact,
                    const std::string& setting) {
  constexpr int places = 8;
  const double contact_radius = std::sqrt(press.radius * press.depth), cell = contact_radius / mesh.cells;
  SceneDesc scene = scene_of(press, mesh, cell, SceneDesc().contact_stiffness);
  SoftDesc& layer = scene.soft[0];
  layer.contact = contact;
  layer.surface_cell = cell;
  CompileOptions options;
  options.threads = 1;
  options.anatomy = [&](const SoftDesc&) -> std::optional<Anatomy> {
    return test::pressed_layer(press.height, 1.5 * contact_radius + cell, cell);
  };
  double least = 1e300, most = 0, sum = 0;
  std::uint32_t points = 0;
  std::optional<ContactRun> run;
  for (int i = 0; i < places; ++i) {  // evenly spread, by the powers of the plastic number
    const double x = cell * std::fmod(0.7548776662466927 * i, 1),
                 z = cell * std::fmod(0.5698402909980532 * i, 1);
    scene.rigid[0].pose.p = {x, press.radius + 1e-4, z};
    const Settled found = settle(run.emplace(scene, options), press, x, z);
    least = std::min(least, found.force);
    most = std::max(most, found.force);
    sum += found.force;
    points = std::max(points, found.points);
  }
  const ReportRow more = {{"element", mesh.element},
                          {"cells_per_contact_radius", mesh.cells},
                          {"contact", contact},
                          {"points", points},
                          {"contact_stiffness", scene.contact_stiffness}};
  const double mean = sum / places;
  rows.add(*run, setting, {"mean force over the table's", "1", mean / press.force, 1, std::nullopt}, more);
  rows.add(*run, setting, {"least and most differ by", "1", (most - least) / mean, 0, std::nullopt}, more);
}

/// A press of the same radius of contact under a ball `times` as large: the table's, scaled as √R·d^1.5, of
/// which the share that is due to the ball's own shape (Sneddon 1965, against the paraboloid) is taken out.
Press flatter(Press p, double times) {
  const auto sneddon = [](double radius, double depth) {  // over the paraboloid's force
    double low = 0, high = radius * 0.99;
    for (int i = 0; i < 60; ++i) {
      const double a = (low + high) / 2;
      (a * std::atanh(a / radius) < depth ? low : high) = a;
    }
    const double a = low, r = radius;
    const double ball = (r * r + a * a) * std::atanh(a / r) - a * r;
    return ball / (4.0 / 3 * std::sqrt(r * depth) * depth);
  };
  const Press from = p;
  p.radius *= times;
  p.depth /= times;
  p.force *= 1 / times * sneddon(p.radius, p.depth) / sneddon(from.radius, from.depth);
  return p;
}

}  // namespace

void hertz_case(ContactRows& rows, bool quick) {
  constexpr double goal = 0.05;
  if (quick) {
    press(rows, presses[1], meshes[1], hertz_contact_stiffness, name(presses[1]), std::nullopt);
    return;
  }
  const Mesh finest = meshes[std::size(meshes) - 1];
  for (const Press& p : presses)
    for (const Mesh& mesh : meshes)
      if (mesh.cells < 1 || (mesh.cells < 2 && mesh.element == std::string("tet4")))
        for (const char* contact : {"surface", "vertices"})
          if (contact == std::string("surface") || p.height == presses[0].height)
            press_all_over(rows, p, mesh, contact,
                           fmt::format("{}, {}, {} cells, all over a cell, {}", name(p), mesh.element,
                                       mesh.cells, contact));
  for (const Press& p : presses) {
    const bool steep = slope(p) > most_slope;
    for (const Mesh& mesh : meshes)
      press(rows, p, mesh, hertz_contact_stiffness,
            fmt::format("{}, {}, {} cells", name(p), mesh.element, mesh.cells),
            mesh.finest ? std::optional(goal) : std::nullopt);
    if (steep)
      press(rows, flatter(p, 8), finest, hertz_contact_stiffness, name(p) + ", under a ball 8 × as large",
            goal);
  }
  // What accounts for the rest: the softness of a scene's contacts; and the ball's slope.
  for (const Press& p : {presses[0], presses[6], presses[8]})
    press(rows, p, finest, SceneDesc().contact_stiffness, name(p) + ", contacts of a scene's default",
          std::nullopt);
  press(rows, flatter(presses[0], 8), finest, hertz_contact_stiffness,
        name(presses[0]) + ", under a ball 8 × as large", std::nullopt);
}

}  // namespace prosector
