// A rigid ball is pressed into a bonded layer without friction, at small strain. The force is compared with
// the finite-layer table, which was computed for vertical surface displacements. A real ball also pushes the
// surface sideways. The difference is of the order (1 − 2ν)·a/R, and vanishes for flat balls and
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

constexpr int most_ticks = 9;     // ticks of 1 s, which makes inertia negligible and updates normals
constexpr double settled = 3e-3;  // relative force change at which a press is settled

using Press = LayerPress;
constexpr auto& presses = layer_presses;

/// The table assumes small slopes; its error is of the order of the squared slope at the contact's edge.
/// Steeper presses are also run with a flatter ball of the same contact radius.
constexpr double most_slope = 1.0 / 3;
double slope(const Press& press) {
  return std::sqrt(press.depth / press.radius);
}

struct Mesh {
  const char* element;
  double cells;  // cells per contact radius √(R·depth)
  bool finest;
};
constexpr Mesh meshes[] = {{"tet4", 0.5, false},  {"tet4", 1, false},  {"tet4", 2, false},
                           {"tet10", 0.5, false}, {"tet10", 1, false}, {"tet10", 2, true}};

SceneDesc scene_of(const Press& press, const Mesh& mesh, double cell, double stiffness) {
  SceneDesc scene = layer_scene(press, mesh.element, cell);
  scene.tick_rate = 1;
  scene.contact_stiffness = stiffness;
  SoftDesc& layer = scene.soft[0];
  layer.material.damping_mass = layer.material.damping_stiffness = 0;
  layer.configuration.newton_iterations = 8;
  layer.configuration.solver_iterations = 500;
  layer.configuration.solver_tolerance = 1e-5;
  if (layer.configuration.element == "tet10") layer.geometry.surface_cell = cell / 2;
  return scene;
}

struct Settled {
  double force = 0, change = 1;  // N; relative change in the last tick
  std::uint32_t points = 0;      // number of pressing contact points
};

/// Holds the ball pressed at (x, z), m, until the force has settled.
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
    if (desc.configuration.element == "tet10") test::halve_surface(made);
    return made;
  };
  SceneDesc scene = scene_of(press, mesh, cell, stiffness);
  scene.soft[0].contact.points = ContactPoints::vertices;  // a stiff contact leaves the mesh's error alone
  ContactRun run(scene, options);
  const Settled found = settle(run, press, 0, 0);
  rows.add(run, setting, {"force over tabulated force", "1", found.force / press.force, 1, tolerance},
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

/// Presses at eight positions in a cell, with default contact stiffness and contacts over the area or, for
/// comparison, at vertices. The force should not depend on the position in the cell.
void press_all_over(ContactRows& rows, const Press& press, const Mesh& mesh, const std::string& contact,
                    const std::string& setting) {
  constexpr int places = 8;
  const double contact_radius = std::sqrt(press.radius * press.depth), cell = contact_radius / mesh.cells;
  SceneDesc scene = scene_of(press, mesh, cell, SceneDesc().contact_stiffness);
  SoftDesc& layer = scene.soft[0];
  layer.contact.points = contact == "surface" ? ContactPoints::surface : ContactPoints::vertices;
  layer.geometry.surface_cell = cell;
  CompileOptions options;
  options.threads = 1;
  options.anatomy = [&](const SoftDesc&) -> std::optional<Anatomy> {
    return test::pressed_layer(press.height, 1.5 * contact_radius + cell, cell);
  };
  double least = 1e300, most = 0, sum = 0;
  std::uint32_t points = 0;
  std::optional<ContactRun> run;
  for (int i = 0; i < places; ++i) {  // low-discrepancy sequence from the plastic number
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
  rows.add(*run, setting, {"mean force over tabulated force", "1", mean / press.force, 1, std::nullopt},
           more);
  rows.add(*run, setting, {"relative force range", "1", (most - least) / mean, 0, std::nullopt}, more);
}

/// Returns the press with the same contact radius and a ball `times` as large. The tabulated force is scaled
/// as √R·d^1.5, and the difference between sphere and paraboloid (Sneddon 1965) is removed.
Press flatter(Press p, double times) {
  const auto sneddon = [](double radius, double depth) {  // ratio of the sphere's to the paraboloid's force
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
                           fmt::format("{}, {}, {} cells, eight positions in a cell, {}", name(p),
                                       mesh.element, mesh.cells, contact));
  for (const Press& p : presses) {
    const bool steep = slope(p) > most_slope;
    for (const Mesh& mesh : meshes)
      press(rows, p, mesh, hertz_contact_stiffness,
            fmt::format("{}, {}, {} cells", name(p), mesh.element, mesh.cells),
            mesh.finest ? std::optional(goal) : std::nullopt);
    if (steep)
      press(rows, flatter(p, 8), finest, hertz_contact_stiffness, name(p) + ", ball 8 times as large", goal);
  }
  // Remaining differences: default contact stiffness, and the ball's slope.
  for (const Press& p : {presses[0], presses[6], presses[8]})
    press(rows, p, finest, SceneDesc().contact_stiffness, name(p) + ", default contact stiffness",
          std::nullopt);
  press(rows, flatter(presses[0], 8), finest, hertz_contact_stiffness,
        name(presses[0]) + ", ball 8 times as large", std::nullopt);
}

}  // namespace prosector
