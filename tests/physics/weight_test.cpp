// How elements bear their weight: by shape functions where something bears the body, by masses where it
// falls.

#include <gtest/gtest.h>

#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double tall = 0.06;  // m: the block

SceneDesc alone(const char* element, const char* integrator = "implicit_euler") {
  SceneDesc scene;
  scene.soft = {block()};
  SoftDesc& soft = scene.soft[0];
  soft.configuration.element = element;
  soft.configuration.integrator = integrator;
  soft.contact.collision = Fidelity::none;
  soft.material.damping_mass = soft.material.damping_stiffness = 0;
  soft.configuration.newton_iterations = 20;
  soft.configuration.solver_tolerance = 1e-10;
  soft.configuration.solver_iterations = 1000;
  return scene;
}

struct Falling {
  const char* element;
  const char* integrator;
};
void PrintTo(const Falling& f, std::ostream* out) {
  *out << f.element << " by " << f.integrator;
}
class Weight : public testing::TestWithParam<Falling> {};
INSTANTIATE_TEST_SUITE_P(Table, Weight,
                         testing::Values(Falling{"tet4", "implicit_euler"},
                                         Falling{"tet10", "implicit_euler"}, Falling{"tet10", "bdf2"},
                                         Falling{"tet10", "tr_bdf2"}, Falling{"tet10", "rk4"}),
                         [](const auto& info) {
                           return std::string(info.param.element) + "_" + info.param.integrator;
                         });

TEST_P(Weight, StrainsNothingInFreeFall) {
  Simulation simulation(alone(GetParam().element, GetParam().integrator), options());
  run(simulation, 20);
  const VecX moved = simulation.soft_state(0).motion.x - simulation.soft(0).rest();
  const auto ways = moved.reshaped(3, moved.size() / 3);
  const Vec3 mean = ways.rowwise().mean();
  EXPECT_LT(mean.y(), -0.3) << "it falls";
  EXPECT_LT((ways.colwise() - mean).cwiseAbs().maxCoeff(), 1e-9);
}

/// A bar of ν = 0 that hangs is longer by ρg(Hy − y²/2)/E at y below what holds it (y measured downwards).
/// That is quadratic, so quadratic elements have it everywhere if each node bears what its shape function
/// has of the weight.
TEST(Weight, IsBornByShapeFunctionsWhereABodyHangs) {
  SceneDesc scene = alone("tet10");
  SoftDesc& soft = scene.soft[0];
  constexpr double modulus = 2e5, flat = 1e4;
  soft.configuration.model = "fem_linear";
  soft.material.youngs_modulus = modulus;
  soft.material.poisson_ratio = 0;
  soft.attach = {{Vec3(0, flat + tall, 0), flat + 1e-6, 1e13}};
  Simulation simulation(scene, options());
  for (int i = 0; i < 2; ++i) {  // at rest as compiled, then awake
    const VecX& x = simulation.soft_state(0).motion.x;
    const VecX& rest = simulation.soft(0).rest();
    const double whole = soft.material.density * 9.81 * tall * tall / (2 * modulus);
    for (Eigen::Index k = 0; k < x.size(); k += 3) {
      const double below = tall - rest[k + 1];
      const double right = soft.material.density * 9.81 * (tall * below - below * below / 2) / modulus;
      EXPECT_NEAR(rest[k + 1] - x[k + 1], right, 1e-3 * whole) << "at " << below;
    }
    simulation.step({});
    run(simulation, 30, appear({0.3, 0.3, 0.3}));
  }
}

}  // namespace
}  // namespace prosector::test
