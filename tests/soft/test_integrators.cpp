// Integrators against the oscillator, whose amplification and order are known.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "common/error.h"
#include "server/physics/soft/time_integrator.h"

namespace prosector {
namespace {

Motion start(double x, double v) {
  Motion m;
  m.x = m.x_prev = VecX::Constant(3, x);
  m.v = m.v_prev = VecX::Constant(3, v);
  return m;
}

/// One step of x″ = −ω²x − 2ζωx′ + g: the stage's minimum in closed form, unit mass.
void step(const TimeIntegrator& method, double h, double omega, double zeta, double g, Motion& m) {
  Stage s;
  for (int stage = 0; stage < method.stages(); ++stage) {
    method.begin(stage, h, Vec3::Constant(g), m, s);
    const double damping = 2 * zeta * omega / s.dxdv;
    const VecX x = (s.alpha * s.y + damping * s.x_v) / (s.alpha + omega * omega + damping);
    method.finish(stage, h, s, x, m);
  }
}

double order(const IntegratorRow& row) {
  const auto method = row.make();
  const double omega = 2 * M_PI, T = 0.3, zeta = 0.1, damped = omega * std::sqrt(1 - zeta * zeta);
  const double exact =
      std::exp(-zeta * omega * T) * (std::cos(damped * T) + zeta * omega / damped * std::sin(damped * T));
  const auto error = [&](int steps) {
    Motion m = start(1, 0);
    for (int i = 0; i < steps; ++i) step(*method, T / steps, omega, zeta, 0, m);
    return std::abs(m.x[0] - exact);
  };
  return std::log2(error(400) / error(800));
}

TEST(Integrators, HaveTheirOrder) {
  for (const IntegratorRow& row : integrators()) {
    const double expected = row.name == std::string("bdf2") ? 2 : 1;
    EXPECT_NEAR(order(row), expected, 0.05) << row.name;
  }
}

TEST(Integrators, AmplifyAsPublished) {
  struct Case {
    const char* name;
    double z, amplification, frequency;
  };
  const Case cases[] = {{"implicit_euler", .1, 1 / std::sqrt(1.01), .99669},
                        {"implicit_euler", .5, 1 / std::sqrt(1.25), .92730},
                        {"bdf2", .1, .99998, .99671},
                        {"bdf2", .5, .99040, .93515}};
  for (const Case& c : cases) {
    const auto method = make_integrator(c.name);
    Motion m = start(1, 0);
    for (int i = 0; i < 50; ++i) step(*method, c.z, 1, 0, 0, m);
    // The parasitic root has died out: x is now Re(A·gᵏ), and three samples tell g + ḡ and |g|².
    double x[4];
    for (double& value : x) {
      value = m.x[0];
      step(*method, c.z, 1, 0, 0, m);
    }
    const double determinant = x[1] * x[1] - x[0] * x[2];
    const double sum = (x[1] * x[2] - x[0] * x[3]) / determinant;
    const double product = (x[2] * x[2] - x[1] * x[3]) / determinant;
    EXPECT_NEAR(std::sqrt(product), c.amplification, 1e-5) << c.name << c.z;
    EXPECT_NEAR(std::acos(sum / (2 * std::sqrt(product))) / c.z, c.frequency, 1e-5) << c.name << c.z;
  }
}

TEST(Integrators, FallFreely) {
  const double h = 1. / 60;
  Motion m = start(0, 0);
  const auto euler = make_integrator("implicit_euler");
  for (int i = 0; i < 60; ++i) step(*euler, h, 0, 0, -9.81, m);
  EXPECT_NEAR(m.x[0], -4.98675, 1e-9);
  EXPECT_NEAR(m.v[0], -9.81, 1e-9);
  m = start(0, 0);
  const auto bdf2 = make_integrator("bdf2");
  for (int i = 0; i < 60; ++i) step(*bdf2, h, 0, 0, -9.81, m);
  EXPECT_NEAR(m.x[0], -4.905, 2 * h * h * 9.81);
  EXPECT_NEAR(m.v[0], -9.81, 1e-9);
}

TEST(Integrators, RestartForgetsThePast) {
  const auto bdf2 = make_integrator("bdf2"), euler = make_integrator("implicit_euler");
  Motion a = start(1, 2), b = start(1, 2);
  a.x_prev.setConstant(100);
  step(*bdf2, 0.1, 3, 0, 1, a);
  step(*euler, 0.1, 3, 0, 1, b);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE(a.has_history);
}

TEST(Integrators, ErrorListsTheRows) {
  try {
    make_integrator("leapfrog");
    FAIL();
  } catch (const InputError& error) {
    for (const auto& row : integrators())
      EXPECT_NE(std::string(error.what()).find(row.name), std::string::npos);
  }
}

}  // namespace
}  // namespace prosector
