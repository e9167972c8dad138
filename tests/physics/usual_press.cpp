#include "tests/physics/usual_press.h"

namespace prosector::test {

SceneDesc usual_layer(double height, double poisson_ratio, double radius) {
  constexpr double above_base = 5e-4;  // m: nodes up to there are held
  SoftDesc layer;
  layer.name = "layer";
  layer.geometry.shape = "block";
  layer.geometry.size = {6 * height, height, 6 * height};
  layer.pose.p.y() = -height / 2;
  layer.material.youngs_modulus = 5000;
  layer.material.poisson_ratio = poisson_ratio;
  layer.gravity = false;
  layer.attach = {bonded_below(height - above_base)};
  return under_ball(layer, radius, {0, radius + 1e-4, 0});
}

}  // namespace prosector::test
