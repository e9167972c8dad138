// A rigid sphere pressed into a bonded elastic layer, against the converged forces of small-strain theory.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/mechanics/coupled/island_solver.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/under_ball.h"

namespace prosector::test {
namespace {

constexpr double youngs_modulus = 5000, radius = 0.01;

struct Layer {
  double height, core, depth, poisson_ratio, force;  // m, m, m, 1, N: converged, ± 0.1 %
};

/// Force of a sphere that is pressed into the layer, N.
double press(const Layer& layer, const std::string& element, double cell) {
  const bool quadratic = element == "tet10";
  SoftDesc desc;
  desc.name = "layer";
  desc.configuration.model = "fem_linear";
  desc.material.youngs_modulus = youngs_modulus;
  desc.material.poisson_ratio = layer.poisson_ratio;
  desc.configuration.element = element;
  if (quadratic) desc.configuration.solver = "multigrid";
  desc.configuration.newton_iterations = 50;
  desc.configuration.solver_iterations = 3000;
  desc.configuration.solver_tolerance = 1e-4;
  desc.attach = {bonded_below(layer.height)};
  Anatomy anatomy = pressed_layer(layer.height, layer.core, cell);
  if (quadratic) halve_surface(anatomy);
  soft::SoftBody body(desc, std::move(anatomy));
  soft::SoftBodyState state = body.initial_state();
  contact::SurfaceDetector surface(body.anatomy().embedding, body.anatomy().surface);
  const std::vector<collision::ShapePart> parts = {
      {collision::ShapeKind::sphere, {radius, 0, 0}, {}, nullptr}};
  std::vector<std::unique_ptr<contact::SignedDistance>> distances;
  distances.push_back(contact::make_signed_distance(parts[0]));
  contact::Collider ball;
  ball.pose.p = {0, radius - layer.depth, 0};
  ball.parts = &parts;
  ball.distances = &distances;
  ball.part_poses = {{}};
  ball.lo = ball.pose.p.array() - radius;
  ball.hi = ball.pose.p.array() + radius;
  double force = 0;
  for (int step = 0; step < 4; ++step) {  // contact normals turn as the surface bends
    surface.update(state.motion.x.data());
    coupled::Island island;
    island.soft.push_back({0, &body, &state});
    surface.near(ball, layer.depth, [&](std::uint32_t vertex, const contact::Distance& d) {
      contact::Contact c;
      c.a.kind = contact::ContactSide::Kind::soft;
      c.a.add(body.anatomy().embedding.rows[vertex], 1);
      c.normal = d.normal;
      c.gap = d.value;
      c.stiffness = 100 * youngs_modulus * body.surface_area()[vertex] / cell;
      island.contacts.push_back(c);
    });
    EXPECT_TRUE(coupled::IslandSolver().solve(island, 1.0).converged);
    state.motion.v.setZero();
    state.warm_start.setZero();
    force = 0;
    for (const contact::Contact& c : island.contacts) force -= c.force * c.normal.y();
  }
  return force;
}

double error_of(const Layer& layer, const std::string& element, double cell) {
  const double error = press(layer, element, cell) / layer.force - 1;
  std::printf("layer %.0f mm, %.0f mm deep, nu %.2f, %s, cells %.1f mm: force %+.1f %%\n", 1e3 * layer.height,
              1e3 * layer.depth, layer.poisson_ratio, element.c_str(), 1e3 * cell, 100 * error);
  return error;
}

// What is left is the linear tetrahedra's: they are too stiff.
TEST(Hertz, LinearElementsConvergeFromAbove) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "takes minutes under a sanitizer, and runs no code of its own";
#endif
  const Layer layer{0.02, 0.005, 0.001, 0.3, 0.02661};
  double last = 1;
  for (const double cell : {0.002, 0.0015, 0.001}) {
    const double error = error_of(layer, "tet4", cell);
    EXPECT_GT(error, 0) << cell;
    EXPECT_LT(error, last) << cell;
    last = error;
  }
  EXPECT_LT(last, 0.08);
}

// With two quadratic cells in a radius of contact, √(Rd).
TEST(Hertz, QuadraticElementsAreWithinFivePercent) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "takes minutes under a sanitizer, and runs no code of its own";
#endif
  const double contact_radius = std::sqrt(radius * 0.001);
  for (const Layer& layer : {Layer{0.02, 1.5 * contact_radius, 0.001, 0.3, 0.02661},
                             Layer{0.02, 1.5 * contact_radius, 0.001, 0.45, 0.03128}})
    EXPECT_LT(std::abs(error_of(layer, "tet10", contact_radius / 2)), 0.05) << layer.poisson_ratio;
}

}  // namespace
}  // namespace prosector::test
