#include "tests/bench/finite_layer.h"

#include <fmt/format.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace prosector {
namespace {

constexpr double layer_modulus = 5000;  // Pa

}  // namespace

std::string name(const LayerPress& press) {
  return fmt::format("layer {:.0f} mm, {:.2g} mm deep, nu {:.2f}", 1e3 * press.height, 1e3 * press.depth,
                     press.poisson_ratio);
}

SceneDesc layer_scene(const LayerPress& press, const std::string& element, double cell) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  const double start = press.radius + 1e-4;
  scene.rigid = {test::part_body("ball", "sphere", {2 * press.radius, 0, 0}, {0, start, 0})};
  scene.rigid[0].fixed = true;
  scene.rigid[0].friction = 0;
  SoftDesc& layer = scene.soft.emplace_back();
  layer.name = "layer";
  layer.model = "fem_linear";
  layer.element = element;
  layer.solver = "multigrid";
  layer.youngs_modulus = layer_modulus;
  layer.poisson_ratio = press.poisson_ratio;
  layer.gravity = false;
  layer.cell = layer.surface_cell = cell;
  // The floor and nothing above it: a ball so large that it is flat, 10 µm high over the middle.
  const double flat = 1000, wide = 4 * press.height;
  layer.attach = {{{0, -press.height - flat, 0}, std::hypot(flat, wide * std::sqrt(2.0)), 1e13}};
  return scene;
}

}  // namespace prosector
