#include "server/physics/mechanics/soft/integrators/explicit_integrators.h"

#include <array>
#include <cmath>

namespace prosector::soft {
namespace {

/// Explicit Euler: x += h·v, v += h·a, both from the start; gains energy at every step.
class ExplicitEuler final : public ExplicitIntegrator {
  VecX a_;
  void step(AccelerationField& field, double h, VecX& x, VecX& v) override {
    field.at(x, v, a_);
    x += h * v;
    v += h * a_;
  }
};

/// Symplectic Euler: advances v first, then x with the new v.
class SymplecticEuler final : public ExplicitIntegrator {
  VecX a_;
  void step(AccelerationField& field, double h, VecX& x, VecX& v) override {
    field.at(x, v, a_);
    v += h * a_;
    x += h * v;
  }
};

/// Midpoint method (Runge 1895).
class Rk2 final : public ExplicitIntegrator {
  VecX a_, x_mid_, v_mid_;
  void step(AccelerationField& field, double h, VecX& x, VecX& v) override {
    field.at(x, v, a_);
    x_mid_ = x + h / 2 * v;
    v_mid_ = v + h / 2 * a_;
    field.at(x_mid_, v_mid_, a_);
    x += h * v_mid_;
    v += h * a_;
  }
};

/// Classical Runge–Kutta method of four stages (Kutta 1901).
class Rk4 final : public ExplicitIntegrator {
  std::array<VecX, 4> a_, v_;  // by stage
  VecX x_stage_;
  void step(AccelerationField& field, double h, VecX& x, VecX& v) override {
    v_[0] = v;
    field.at(x, v_[0], a_[0]);
    for (std::size_t i = 1; i < 4; ++i) {
      const double c = i == 3 ? h : h / 2;
      x_stage_ = x + c * v_[i - 1];
      v_[i] = v + c * a_[i - 1];
      field.at(x_stage_, v_[i], a_[i]);
    }
    x += h / 6 * (v_[0] + 2 * v_[1] + 2 * v_[2] + v_[3]);
    v += h / 6 * (a_[0] + 2 * a_[1] + 2 * a_[2] + a_[3]);
  }
};

/// Position Verlet: half a drift step on either side of the force evaluation. Damping uses the velocity at
/// the midpoint, which needs one more evaluation.
class Verlet final : public ExplicitIntegrator {
  VecX a_, v_mid_;
  void step(AccelerationField& field, double h, VecX& x, VecX& v) override {
    x += h / 2 * v;
    field.at(x, v, a_);
    if (field.damped()) {
      v_mid_ = v + h / 2 * a_;
      field.at(x, v_mid_, a_);
    }
    v += h * a_;
    x += h / 2 * v;
  }
};

template <class Method>
std::unique_ptr<ExplicitIntegrator> make() {
  return std::make_unique<Method>();
}

class Oscillator final : public AccelerationField {
 public:
  Oscillator(double stiffness, double damping) : stiffness_(stiffness), damping_(damping) {}
  void at(const VecX& x, const VecX& v, VecX& a) override { a = -stiffness_ * x - damping_ * v; }
  bool damped() const override { return damping_ > 0; }

 private:
  double stiffness_, damping_;
};

constexpr double no_growth = 1 + 1e-14;
constexpr double least_step = 1e-3;  // ωh: a method with a smaller limit counts as unstable
constexpr double most_step = 4;      // ωh: no method is stable here

}  // namespace

const std::vector<ExplicitRow>& explicit_integrators() {
  static const std::vector<ExplicitRow> rows = {
      {"explicit_euler",
       "explicit integrator of first order; gains energy unless damped; for comparison only", 1,
       make<ExplicitEuler>},
      {"symplectic_euler", "explicit integrator of first order, symplectic; the cheapest stable explicit one",
       1, make<SymplecticEuler>},
      {"rk2",
       "explicit midpoint method of second order; gains energy slowly unless damped; for comparison only", 2,
       make<Rk2>},
      {"rk4", "explicit integrator of fourth order; four force evaluations per substep; for accurate motion",
       4, make<Rk4>},
      {"verlet",
       "explicit integrator of second order, symplectic; one force evaluation per substep without damping", 2,
       make<Verlet>},
  };
  return rows;
}

StepLimit::StepLimit(ExplicitIntegrator& method) : method_(method), x_(2), v_(2) {}

/// Returns the spectral radius of one step of size z/ω, from the images of (1, 0) and (0, 1).
double StepLimit::growth(AccelerationField& oscillator, double z) {
  x_ << 1, 0;
  v_ << 0, 1;
  method_.step(oscillator, z, x_, v_);
  const double half_trace = (x_[0] + v_[1]) / 2, determinant = x_[0] * v_[1] - x_[1] * v_[0];
  const double discriminant = half_trace * half_trace - determinant;
  if (discriminant < 0) return std::sqrt(determinant);
  return std::abs(half_trace) + std::sqrt(discriminant);
}

double StepLimit::at(double omega, double damping_mass, double damping_stiffness) {
  Oscillator oscillator(1, damping_mass / omega + damping_stiffness * omega);
  double holds = 0, grows = most_step;
  for (int i = 0; i < 60; ++i) {
    const double middle = (holds + grows) / 2;
    (growth(oscillator, middle) <= no_growth ? holds : grows) = middle;
  }
  return holds < least_step && !oscillator.damped() ? 0 : holds / omega;
}

}  // namespace prosector::soft
