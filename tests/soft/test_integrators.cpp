// Integrators against the oscillator, whose amplification and order are known.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/error.h"
#include "server/physics/soft/explicit_integrators.h"
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

/// x″ = −ω²x − 2ζωx′ + g for explicit methods.
class Oscillator final : public AccelerationField {
 public:
  Oscillator(double omega, double zeta, double g) : omega_(omega), zeta_(zeta), g_(g) {}
  void at(const VecX& x, const VecX& v, VecX& a) override {
    a = -omega_ * omega_ * x - 2 * zeta_ * omega_ * v;
    a.array() += g_;
  }
  bool damped() const override { return zeta_ > 0; }

 private:
  double omega_, zeta_, g_;
};

/// One method of either table, on the oscillator.
struct Method {
  std::string name;
  int order;
  std::shared_ptr<TimeIntegrator> stages;
  std::shared_ptr<ExplicitIntegrator> forces;

  void advance(double h, double omega, double zeta, double g, Motion& m) const {
    if (stages) return step(*stages, h, omega, zeta, g, m);
    Oscillator oscillator(omega, zeta, g);
    forces->step(oscillator, h, m.x, m.v);
  }
};

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const IntegratorRow& row : integrators()) all.push_back({row.name, row.order, row.make(), nullptr});
  for (const ExplicitRow& row : explicit_integrators())
    all.push_back({row.name, row.order, nullptr, row.make()});
  return all;
}

Method method(const std::string& name) {
  for (const Method& m : methods())
    if (m.name == name) return m;
  throw InputError(name);
}

double order(const Method& method, double zeta) {
  const double omega = 2 * M_PI, T = 0.3, damped = omega * std::sqrt(1 - zeta * zeta);
  const double exact =
      std::exp(-zeta * omega * T) * (std::cos(damped * T) + zeta * omega / damped * std::sin(damped * T));
  const auto error = [&](int steps) {
    Motion m = start(1, 0);
    for (int i = 0; i < steps; ++i) method.advance(T / steps, omega, zeta, 0, m);
    return std::abs(m.x[0] - exact);
  };
  const int steps = method.order == 4 ? 40 : 400;
  return std::log2(error(steps) / error(2 * steps));
}

TEST(Integrators, HaveTheirOrder) {
  for (const Method& m : methods())
    for (const double zeta : {0.0, 0.1}) EXPECT_NEAR(order(m, zeta), m.order, 0.1) << m.name << " " << zeta;
}

/// |g| and arg(g)/z of the principal root from four samples of x = Re(A·gᵏ), once parasitic roots have died
/// out: x_{k+1} = (g + ḡ)·x_k − |g|²·x_{k−1}.
std::pair<double, double> amplification(const Method& method, double z) {
  Motion m = start(1, 0);
  for (int i = 0; i < 50; ++i) method.advance(z, 1, 0, 0, m);
  double x[4];
  for (double& value : x) {
    value = m.x[0];
    method.advance(z, 1, 0, 0, m);
  }
  const double determinant = x[1] * x[1] - x[0] * x[2];
  const double sum = (x[1] * x[2] - x[0] * x[3]) / determinant;
  const double product = (x[2] * x[2] - x[1] * x[3]) / determinant;
  return {std::sqrt(product), std::acos(sum / (2 * std::sqrt(product))) / z};
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
    const auto [growth, frequency] = amplification(method(c.name), c.z);
    EXPECT_NEAR(growth, c.amplification, 1e-5) << c.name << " " << c.z;
    EXPECT_NEAR(frequency, c.frequency, c.digits) << c.name << " " << c.z;
  }
  for (const Method& m : methods()) EXPECT_TRUE(covered.count(m.name)) << m.name;
}

/// Whether 40,000 steps keep x bounded: next to the limit it beats up to some times its start.
bool holds(const Method& method, double z, double zeta = 0) {
  Motion m = start(1, 0);
  for (int i = 0; i < 40000; ++i) {
    method.advance(z, 1, zeta, 0, m);
    if (!(std::abs(m.x[0]) < 20)) return false;
  }
  return true;
}

TEST(Integrators, HoldUpToTheirLimit) {
  struct Case {
    const char* name;
    double limit;  // ωh; 0: never holds
  };
  for (const Case& c :
       {Case{"explicit_euler", 0}, {"symplectic_euler", 2}, {"verlet", 2}, {"rk2", 0}, {"rk4", 2.8284}}) {
    const Method m = method(c.name);
    EXPECT_NEAR(stable_step(*m.forces, 1), c.limit, 0.001) << c.name;
    EXPECT_NEAR(stable_step(*m.forces, 50) * 50, c.limit, 0.001) << c.name;
    if (c.limit > 0) {
      EXPECT_TRUE(holds(m, 0.99 * c.limit)) << c.name;
      EXPECT_FALSE(holds(m, 1.02 * c.limit)) << c.name;
    } else {
      EXPECT_FALSE(holds(m, 0.5)) << c.name;
    }
    for (const double zeta : {0.05, 0.5, 5.0}) {
      const double limit = stable_step(*m.forces, 1, 2 * zeta);
      EXPECT_GT(limit, 0) << c.name;
      EXPECT_TRUE(holds(m, 0.99 * limit, zeta)) << c.name << " " << zeta;
      EXPECT_FALSE(holds(m, 1.02 * limit, zeta)) << c.name << " " << zeta;
    }
  }
  EXPECT_NEAR(stable_step(*method("explicit_euler").forces, 1, 0.2), 0.2, 1e-6);  // h < 2ζ/ω
  for (const IntegratorRow& row : integrators())
    for (const double z : {3.0, 30.0, 3e4}) EXPECT_TRUE(holds(method(row.name), z)) << row.name << " " << z;
}

TEST(Integrators, DampAsTheSpringDoes) {
  struct Case {
    double zeta, x[3];
  };
  for (const Case& c : {Case{.1, {.0926205783, -.7291561864, .5315351237}},
                        Case{1, {.5344160513, .1789744464, .0136009315}}}) {
    for (const Method& m : methods()) {
      const double times[] = {.25, .5, 1};
      for (int k = 0; k < 3; ++k) {
        const int steps = 4096;
        Motion motion = start(1, 0);
        for (int i = 0; i < steps; ++i) m.advance(times[k] / steps, 2 * M_PI, c.zeta, 0, motion);
        EXPECT_NEAR(motion.x[0], c.x[k], m.order == 1 ? 5e-3 : 1e-5) << m.name << " " << times[k];
      }
    }
  }
}

TEST(Integrators, FallFreely) {
  const double h = 1. / 60;
  for (const Method& m : methods()) {
    Motion motion = start(0, 0);
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
