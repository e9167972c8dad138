// A rigid sphere pressed into a bonded elastic layer, against the converged forces of small-strain theory.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "server/physics/contact/surface_detector.h"
#include "server/physics/coupled/island_solver.h"
#include "tests/physics/pressed_layer.h"

namespace prosector::test {
namespace {

constexpr double youngs_modulus = 5000, radius = 0.01;

/// Force of a sphere that is pressed `depth` into the layer, N.
double press(double height, double core, double depth, double cell) {
  SoftDesc desc;
  desc.name = "layer";
  desc.model = "fem_linear";
  desc.youngs_modulus = youngs_modulus;
  desc.poisson_ratio = 0.3;
  desc.newton_iterations = 50;
  desc.solver_iterations = 3000;
  desc.solver_tolerance = 1e-4;
  // The floor and nothing above it: a ball so large that it is flat, 10 µm high over the middle.
  const double flat = 1000, wide = 4 * height;
  desc.attach = {{{0, -height - flat, 0}, std::hypot(flat, wide * std::sqrt(2.0)), 1e13}};
  SoftBody body(desc, pressed_layer(height, core, cell));
  SoftBodyState state = body.initial_state();
  SurfaceDetector surface(body.anatomy().embedding, body.anatomy().surface);
  const std::vector<ShapePart> parts = {{ShapeKind::sphere, {radius, 0, 0}, {}, nullptr}};
  std::vector<std::unique_ptr<SignedDistance>> distances;
  distances.push_back(make_signed_distance(parts[0]));
  Collider ball;
  ball.pose.p = {0, radius - depth, 0};
  ball.parts = &parts;
  ball.distances = &distances;
  ball.part_poses = {{}};
  ball.lo = ball.pose.p.array() - radius;
  ball.hi = ball.pose.p.array() + radius;
  double force = 0;
  for (int step = 0; step < 4; ++step) {  // contact normals turn as the surface bends
    surface.update(state.motion.x.data());
    Island island;
    island.soft.push_back({0, &body, &state});
    surface.near(ball, depth, [&](std::uint32_t vertex, const Distance& d) {
      Contact c;
      c.a.kind = ContactSide::Kind::soft;
      c.a.add(body.anatomy().embedding.rows[vertex], 1);
      c.normal = d.normal;
      c.gap = d.value;
      c.stiffness = 100 * youngs_modulus * body.surface_area()[vertex] / cell;
      island.contacts.push_back(c);
    });
    EXPECT_TRUE(IslandSolver().solve(island, 1.0, Vec3::Zero()).converged);
    state.motion.v.setZero();
    state.warm_start.setZero();
    force = 0;
    for (const Contact& c : island.contacts) force -= c.force * c.normal.y();
  }
  return force;
}

struct Layer {
  double height, core, depth, force;  // m, m, m, N: converged, ± 0.1 %
  std::vector<double> cells;
  double finest_error;
};

// What is left at the finest mesh is the linear tetrahedra's and the coarse far mesh's: 6.3 % at cells of
// 0.5 mm, where a step takes minutes.
TEST(Hertz, ForceConvergesToTheLayersFromAbove) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "takes minutes under a sanitizer, and runs no code of its own";
#endif
  for (const Layer& l : {Layer{0.02, 0.005, 0.001, 0.02661, {0.002, 0.0015, 0.001}, 0.08},
                         Layer{0.05, 0.006, 0.002, 0.06951, {0.004, 0.002}, 0.10}}) {
    double last = 1;
    for (const double cell : l.cells) {
      const double error = press(l.height, l.core, l.depth, cell) / l.force - 1;
      std::printf("layer %.0f mm, depth %.0f mm, cells %.1f mm: force %+.1f %%\n", 1e3 * l.height,
                  1e3 * l.depth, 1e3 * cell, 100 * error);
      EXPECT_GT(error, 0) << cell;
      EXPECT_LT(error, last) << cell;
      last = error;
    }
    EXPECT_LT(last, l.finest_error) << l.height;
  }
}

}  // namespace
}  // namespace prosector::test
