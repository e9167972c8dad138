#include "tests/bench/pressed_tissue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/embedding.h"
#include "common/error.h"
#include "common/paths.h"
#include "server/accuracy/body_trial.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/under_ball.h"

namespace prosector {
namespace {

constexpr double radius = 0.01;        // m, of the ball
constexpr double layer_height = 0.02;  // m
const Vec3 layer_size(0.12, layer_height, 0.12), organ_size(0.16, 0.08, 0.12),
    liver_size(0.206, 0.149, 0.171);
constexpr double organ_surface_cell = 0.004, liver_surface_cell = 0.004;  // m
constexpr double layer_core = 0.0065;  // m: half width of the pressed region

void shape_layer(SoftDesc& desc) {
  desc.geometry.shape = "block";
  desc.attach = {test::bonded_below(layer_height)};
}

Anatomy layer_block(double cell) {
  return test::even_layer(layer_size.x(), layer_height, cell);
}

/// Gives a refined mesh the surface of the mesh that it is refined to.
Anatomy layer_mesh(const SoftDesc& desc) {
  Anatomy coarse = layer_block(desc.geometry.cell);
  if (desc.refinement.cell == 0) return coarse;
  return embed(std::move(coarse.tets), layer_block(desc.refinement.cell).surface).anatomy;
}

Anatomy graded_layer(const SoftDesc& desc) {
  return test::pressed_layer(layer_height, layer_core, desc.geometry.cell);
}

void shape_organ(SoftDesc& desc) {
  desc.geometry.shape = "liver";
  desc.geometry.size = organ_size;
  desc.geometry.surface_cell = organ_surface_cell;
  constexpr double bed = 1, deep = 0.02;  // m: radius of the bed, and its depth below the centre
  desc.attach = {{{0, -bed - deep, 0}, bed, 1e10}};
}

void shape_liver(SoftDesc& desc) {
  desc.geometry.volume = "liver.inr.gz";
  desc.geometry.label = 255;
  desc.pose.q = Quat(0, 1, 0, 0);  // rotates the supine CT image
  desc.geometry.fallback = "liver";
  desc.geometry.size = liver_size;
  desc.material.youngs_modulus = 5400;
  desc.geometry.surface_cell = liver_surface_cell;
  constexpr double bed = 1, deep = 0.03;  // m: the bed holds the lowest 55 mm
  desc.attach = {{{0, -bed - deep, 0}, bed, 1e10}};
}

/// Returns the highest intersection of the surface with the vertical through the centre.
Vec3 top_of(const TriangleMesh& surface) {
  constexpr double rim = -1e-9;  // tolerance: a point on an edge belongs to both triangles
  Vec3 top(0, -1e300, 0);
  for (const auto& [i, j, k] : surface.triangles) {
    const Vec3 &a = surface.positions[i], &b = surface.positions[j], &c = surface.positions[k];
    const auto twice = [](const Vec3& p, const Vec3& q) { return p.x() * q.z() - p.z() * q.x(); };
    const Vec3 shares =
        Vec3(twice(b, c), twice(c, a), twice(a, b)) / (twice(b, c) + twice(c, a) + twice(a, b));
    if (!(shares.minCoeff() >= rim)) continue;
    top.y() = std::max(top.y(), shares.dot(Vec3(a.y(), b.y(), c.y())));
  }
  return top;
}

Vec3 highest(const TriangleMesh& surface) {
  return *std::max_element(surface.positions.begin(), surface.positions.end(),
                           [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
}

SceneDesc scene_of(const SoftDesc& desc, const PressSettings& settings) {
  SceneDesc scene = test::under_ball(desc, radius, {0, 1, 0});
  scene.tick_rate = 1 / settings.tick;
  scene.contact_stiffness = settings.contact_stiffness;
  return scene;
}

CompileOptions options_of(const PressedBody& body, const PressSettings& settings) {
  CompileOptions out;
  out.threads = settings.threads;
  out.data_dirs = {default_data_dir()};
  const auto mesh = settings.graded && body.graded_mesh ? body.graded_mesh : body.mesh;
  if (mesh) out.anatomy = [=](const SoftDesc& desc) -> std::optional<Anatomy> { return mesh(desc); };
  return out;
}

/// Returns the mesh with cells of `wide` m, locally refined under the pressing ball.
Anatomy graded_by_press(const PressedBody& body, const SoftDesc& desc, double wide) {
  constexpr double reach = 0.02;  // m
  constexpr int ticks = 40;       // more than refinement needs
  SoftDesc coarse = pressed_desc(body, wide, desc.geometry.cell);
  coarse.refinement.reach = reach;
  coarse.geometry.surface_cell = desc.geometry.surface_cell;
  coarse.refinement.max_elements = 100000;
  PressedTissue tissue(body, coarse);
  for (int tick = 1; tick <= ticks; ++tick) tissue.press(body.depth * tick / ticks);
  return tissue.simulation().soft(1).anatomy();
}

Anatomy graded_organ(const SoftDesc& desc) {
  constexpr double wide = 0.012;  // m
  return graded_by_press(pressed_organ(), desc, std::max(desc.geometry.cell, wide));
}

Anatomy graded_liver(const SoftDesc& desc) {
  return graded_by_press(pressed_liver(), desc, 2 * desc.geometry.cell);  // the cells determine its outline
}

}  // namespace

const PressedBody& pressed_layer_body() {
  static const PressedBody body = {"layer",      "a layer", 0.002, layer_size.x(), shape_layer, layer_mesh,
                                   graded_layer, 0.0920,    0.02};
  return body;
}

const PressedBody& pressed_organ() {
  static const PressedBody body = {"organ",      "an organ", 0.01, organ_size.x(), shape_organ, nullptr,
                                   graded_organ, 0.592,      0.02};
  return body;
}

const PressedBody& pressed_liver() {
  static const PressedBody body = {"liver", "a liver",    0.01,  liver_size.x(), shape_liver,
                                   nullptr, graded_liver, 0.258, 0.02,           true};
  return body;
}

SoftDesc pressed_desc(const PressedBody& body, double cell, double refine_cell) {
  SoftDesc desc;
  desc.name = "tissue";
  desc.configuration.model = tissue_law;
  desc.configuration.solver = "multigrid";
  desc.material.youngs_modulus = 5000;
  desc.material.poisson_ratio = 0.45;
  desc.geometry.cell = cell;
  desc.contact.points = ContactPoints::surface;
  desc.material.damping_mass = 5;
  desc.configuration.newton_iterations = 6;  // with three, the force of a deep press oscillates
  body.shape(desc);
  if (refine_cell > 0) {
    desc.refinement.at = Refining::touch;
    desc.refinement.cell = refine_cell;
    desc.refinement.reach = radius;
    desc.refinement.max_elements = 20000;
  }
  return desc;
}

PressedTissue::PressedTissue(const PressedBody& body, const SoftDesc& desc, const PressSettings& settings)
    : simulation_(scene_of(desc, settings), options_of(body, settings)),
      top_((body.by_image ? highest : top_of)(simulation_.surface(1))) {}

const StepReport& PressedTissue::press(double depth, double along) {
  return simulation_.step(test::ball_at(top_ + Vec3(along, radius - depth, 0)));
}

double PressedTissue::force() const {
  return test::pressing_force(simulation_);
}

std::size_t PressedTissue::tets() const {
  return tet_count(simulation_);
}

double force_at_rest(const PressedBody& body, SoftDesc desc) {
  desc.configuration.element = "tet10";
  if (!body.by_image)
    desc.geometry.surface_cell = std::min(desc.geometry.surface_cell, desc.geometry.cell / 2);
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  desc.configuration.newton_iterations = 40;
  desc.configuration.solver_iterations = 500;
  desc.configuration.solver_tolerance = 1e-4;
  desc.material.density = 1e-3;  // kg/m³: makes inertia negligible in ticks of 1 ms
  PressSettings settings;
  settings.tick = 1e-3;  // s: ends before an inverted tetrahedron triggers the recovery law
  settings.contact_stiffness = 200;
  settings.graded = true;
  PressedTissue tissue(body, desc, settings);
  constexpr double stride = 7e-4;  // m: indentation per step; larger steps may not converge
  const int ways = static_cast<int>(std::ceil(body.depth / stride));
  for (int i = 1; i <= ways; ++i) tissue.press(body.depth * i / ways);
  double last = tissue.force();
  constexpr int most_ticks = 12;
  constexpr double settled = 5e-4;  // relative force change per tick at convergence
  for (int i = 0; i < most_ticks; ++i) {
    tissue.press(body.depth);
    const double now = tissue.force();
    if (std::abs(now / last - 1) < settled) break;
    last = now;
  }
  if (tissue.simulation().soft_state(1).recovering)
    throw InputError(
        fmt::format("{}: elements inverted at this depth, so the recovery law took over", body.name));
  return tissue.force();
}

}  // namespace prosector
