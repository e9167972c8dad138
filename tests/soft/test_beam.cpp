// The cantilever whose values on this very mesh other codes agree on.

#include <gtest/gtest.h>

#include "tests/soft/kuhn.h"
#include "tests/soft/stepper.h"

namespace prosector {
namespace {

const Vec3 gravity(0, -9.81, 0);
const Vec3 beam_size(0.4, 0.1, 0.1);

/// 8×2×2 cells, clamped at x = 0.
soft::SoftBody beam(const char* model, double poisson_ratio, const char* solver = "direct") {
  SoftDesc desc;
  desc.name = "beam";
  desc.configuration.model = model;
  desc.configuration.solver = solver;
  desc.material.youngs_modulus = 3e5;
  desc.material.poisson_ratio = poisson_ratio;
  desc.material.density = 1000;
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  // A sphere so large that its surface is the plane x = 0 to within a hair.
  desc.attach.push_back({Vec3(-1e4, 0.05, 0.05), 1e4 + 1e-6, 1e16});
  return {desc, kuhn_anatomy({8, 2, 2}, beam_size)};
}

Vec3 tip(const soft::SoftBodyState& state) {
  const Eigen::Index node = (1 * 3 + 1) * 9 + 8;
  return state.motion.x.segment<3>(3 * node);
}

struct Case {
  const char* model;
  double poisson_ratio, deflection;
};

TEST(Beam, StaticDeflectionOnThisMesh) {
  const Case cases[] = {
      {"fem_linear", 0, .07406306},
      {"fem_linear", .3, .06877259},
      {"fem_linear", .45, .04294061},
      {"fem_linear", .49, .02044636},
      {"fem_corotational", .3, .06788235},
      {"fem_corotational", .45, .04312521},
      {"fem_neo_hookean_polynomial", .3, .06856760},
      {"fem_neo_hookean_polynomial", .45, .04392293},
  };
  for (const Case& c : cases) {
    soft::SoftBody body = beam(c.model, c.poisson_ratio);
    soft::SoftBodyState state = body.initial_state();
    Stepper(body).settle(gravity, state);
    EXPECT_NEAR(0.05 - tip(state)[1], c.deflection, 2e-8) << c.model << " " << c.poisson_ratio;
  }
}

}  // namespace
}  // namespace prosector
