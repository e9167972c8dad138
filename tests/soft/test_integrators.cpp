// Integrators against the oscillator, whose amplification and order are known.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "common/error.h"
#include "tests/soft/oscillator.h"

namespace prosector {
namespace {

TEST(Integrators, HaveTheirOrder) {
  for (const OscillatorMethod& m : oscillator_methods())
    for (const double zeta : {0.0, 0.1})
      EXPECT_NEAR(observed_order(m, zeta), m.order, 0.1) << m.name << " " << zeta;
}

TEST(Integrators, AmplifyAsTheoryAndPublished) {
  struct Case {
    const char* name;
    double z, amplification, frequency, digits;
  };
  const auto rk4 = [](double z) { return std::sqrt(1 - std::pow(z, 6) / 72 + std::pow(z, 8) / 576); };
  const auto rk2 = [](double z) { return std::sqrt(1 + std::pow(z, 4) / 4); };
  const Case cases[] = {{"explicit_euler", .1, std::sqrt(1.01), .99669, 1e-5},
                        {"explicit_euler", .5, std::sqrt(1.25), .92730, 1e-5},
                        {"symplectic_euler", .1, 1, 1.000417, 1e-6},
                        {"symplectic_euler", .5, 1, 1.01072, 1e-5},
                        {"verlet", .1, 1, 1.000417, 1e-6},
                        {"verlet", .5, 1, 1.01072, 1e-5},
                        {"rk2", .1, rk2(.1), 1.00166, 1e-5},
                        {"rk2", .5, rk2(.5), 1.0383, 1e-4},
                        {"rk4", .1, rk4(.1), .9999992, 1e-7},
                        {"rk4", .5, rk4(.5), .99952, 1e-5},
                        {"implicit_euler", .1, 1 / std::sqrt(1.01), .99669, 1e-5},
                        {"implicit_euler", .5, 1 / std::sqrt(1.25), .92730, 1e-5},
                        {"tr_bdf2", .1, .9999996, .99960, 1e-5},
                        {"tr_bdf2", .5, .99978, .99009, 1e-5},
                        {"bdf2", .1, .99998, .99671, 1e-5},
                        {"bdf2", .5, .99040, .93515, 1e-5}};
  std::set<std::string> covered;
  for (const Case& c : cases) {
    covered.insert(c.name);
    const auto [growth, frequency] = amplification(oscillator_method(c.name), c.z);
    EXPECT_NEAR(growth, c.amplification, 1e-5) << c.name << " " << c.z;
    EXPECT_NEAR(frequency, c.frequency, c.digits) << c.name << " " << c.z;
  }
  for (const OscillatorMethod& m : oscillator_methods()) EXPECT_TRUE(covered.count(m.name)) << m.name;
}

TEST(Integrators, HoldUpToTheirLimit) {
  struct Case {
    const char* name;
    double limit;  // ωh; 0: never holds
  };
  for (const Case& c :
       {Case{"explicit_euler", 0}, {"symplectic_euler", 2}, {"verlet", 2}, {"rk2", 0}, {"rk4", 2.8284}}) {
    const OscillatorMethod m = oscillator_method(c.name);
    EXPECT_NEAR(soft::StepLimit(*m.forces).at(1), c.limit, 0.001) << c.name;
    EXPECT_NEAR(soft::StepLimit(*m.forces).at(50) * 50, c.limit, 0.001) << c.name;
    if (c.limit > 0) {
      EXPECT_TRUE(holds(m, 0.99 * c.limit)) << c.name;
      EXPECT_FALSE(holds(m, 1.02 * c.limit)) << c.name;
    } else {
      EXPECT_FALSE(holds(m, 0.5)) << c.name;
    }
    for (const double zeta : {0.05, 0.5, 5.0}) {
      const double limit = soft::StepLimit(*m.forces).at(1, 2 * zeta);
      EXPECT_GT(limit, 0) << c.name;
      EXPECT_TRUE(holds(m, 0.99 * limit, zeta)) << c.name << " " << zeta;
      EXPECT_FALSE(holds(m, 1.02 * limit, zeta)) << c.name << " " << zeta;
    }
  }
  EXPECT_NEAR(soft::StepLimit(*oscillator_method("explicit_euler").forces).at(1, 0.2), 0.2,
              1e-6);  // h < 2ζ/ω
  for (const soft::IntegratorRow& row : soft::integrators())
    for (const double z : {3.0, 30.0, 3e4})
      EXPECT_TRUE(holds(oscillator_method(row.name), z)) << row.name << " " << z;
}

TEST(Integrators, DampAsTheSpringDoes) {
  struct Case {
    double zeta, x[3];
  };
  for (const Case& c : {Case{.1, {.0926205783, -.7291561864, .5315351237}},
                        Case{1, {.5344160513, .1789744464, .0136009315}}}) {
    for (const OscillatorMethod& m : oscillator_methods()) {
      const double times[] = {.25, .5, 1};
      for (int k = 0; k < 3; ++k) {
        const int steps = 4096;
        soft::Motion motion = oscillator_at(1, 0);
        for (int i = 0; i < steps; ++i) m.advance(times[k] / steps, 2 * M_PI, c.zeta, 0, motion);
        EXPECT_NEAR(motion.x[0], c.x[k], m.order == 1 ? 5e-3 : 1e-5) << m.name << " " << times[k];
      }
    }
  }
}

TEST(Integrators, FallFreely) {
  const double h = 1. / 60;
  for (const OscillatorMethod& m : oscillator_methods()) {
    soft::Motion motion = oscillator_at(0, 0);
    for (int i = 0; i < 60; ++i) m.advance(h, 0, 0, -9.81, motion);
    EXPECT_NEAR(motion.v[0], -9.81, 1e-9) << m.name;
    if (m.name == "symplectic_euler" || m.name == "implicit_euler")
      EXPECT_NEAR(motion.x[0], -4.98675, 1e-9) << m.name;
    else if (m.name == "explicit_euler")
      EXPECT_NEAR(motion.x[0], -4.82325, 1e-9);
    else if (m.stages)
      EXPECT_NEAR(motion.x[0], -4.905, 2 * h * h * 9.81) << m.name;
    else
      EXPECT_NEAR(motion.x[0], -4.905, 1e-9) << m.name;
  }
}

TEST(Integrators, RestartForgetsThePast) {
  soft::Motion a = oscillator_at(1, 2), b = oscillator_at(1, 2);
  a.x_prev.setConstant(100);
  oscillator_method("bdf2").advance(0.1, 3, 0, 1, a);
  oscillator_method("implicit_euler").advance(0.1, 3, 0, 1, b);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE(a.has_history);
}

TEST(Integrators, ErrorListsTheRows) {
  try {
    soft::make_integrator("leapfrog");
    FAIL();
  } catch (const InputError& error) {
    for (const auto& row : soft::integrators())
      EXPECT_NE(std::string(error.what()).find(row.name), std::string::npos);
  }
}

}  // namespace
}  // namespace prosector
