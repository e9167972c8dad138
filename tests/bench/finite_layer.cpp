#include "tests/bench/finite_layer.h"

#include <fmt/format.h>

#include "tests/physics/under_ball.h"

namespace prosector {
namespace {

constexpr double layer_modulus = 5000;  // Pa

}  // namespace

std::string name(const LayerPress& press) {
  return fmt::format("layer {:.0f} mm, {:.2g} mm deep, nu {:.2f}", 1e3 * press.height, 1e3 * press.depth,
                     press.poisson_ratio);
}

SceneDesc layer_scene(const LayerPress& press, const std::string& element, double cell) {
  SoftDesc layer;
  layer.name = "layer";
  layer.configuration.model = "fem_linear";
  layer.configuration.element = element;
  layer.configuration.solver = "multigrid";
  layer.material.youngs_modulus = layer_modulus;
  layer.material.poisson_ratio = press.poisson_ratio;
  layer.gravity = false;
  layer.geometry.cell = layer.geometry.surface_cell = cell;
  layer.attach = {test::bonded_below(press.height)};
  return test::under_ball(layer, press.radius, {0, press.radius + 1e-4, 0});
}

}  // namespace prosector
