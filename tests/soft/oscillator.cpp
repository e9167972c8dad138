#include "tests/soft/oscillator.h"

#include <cmath>
#include <stdexcept>

namespace prosector {
namespace {

/// The stage's minimum in closed form, unit mass.
void step(const soft::TimeIntegrator& method, double h, double omega, double zeta, double g,
          soft::Motion& m) {
  soft::Stage s;
  for (int stage = 0; stage < method.stages(); ++stage) {
    method.begin(stage, h, Vec3(Vec3::Constant(g)), m, s);
    const double damping = 2 * zeta * omega / s.dxdv;
    const VecX x = (s.alpha * s.y + damping * s.x_v) / (s.alpha + omega * omega + damping);
    method.finish(stage, h, s, x, m);
  }
}

/// For explicit methods.
class Oscillator final : public soft::AccelerationField {
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

}  // namespace

soft::Motion oscillator_at(double x, double v) {
  soft::Motion m;
  m.x = m.x_prev = VecX::Constant(3, x);
  m.v = m.v_prev = VecX::Constant(3, v);
  return m;
}

void OscillatorMethod::advance(double h, double omega, double zeta, double g, soft::Motion& m) const {
  if (stages) return step(*stages, h, omega, zeta, g, m);
  Oscillator oscillator(omega, zeta, g);
  forces->step(oscillator, h, m.x, m.v);
}

std::vector<OscillatorMethod> oscillator_methods() {
  std::vector<OscillatorMethod> all;
  for (const soft::IntegratorRow& row : soft::integrators())
    all.push_back({row.name, row.order, row.make(), nullptr});
  for (const soft::ExplicitRow& row : soft::explicit_integrators())
    all.push_back({row.name, row.order, nullptr, row.make()});
  return all;
}

OscillatorMethod oscillator_method(const std::string& name) {
  for (const OscillatorMethod& m : oscillator_methods())
    if (m.name == name) return m;
  throw std::out_of_range(name);
}

double observed_order(const OscillatorMethod& method, double zeta) {
  const double omega = 2 * M_PI, T = 0.3, damped = omega * std::sqrt(1 - zeta * zeta);
  const double exact =
      std::exp(-zeta * omega * T) * (std::cos(damped * T) + zeta * omega / damped * std::sin(damped * T));
  const auto error = [&](int steps) {
    soft::Motion m = oscillator_at(1, 0);
    for (int i = 0; i < steps; ++i) method.advance(T / steps, omega, zeta, 0, m);
    return std::abs(m.x[0] - exact);
  };
  const int steps = method.order == 4 ? 40 : 400;
  return std::log2(error(steps) / error(2 * steps));
}

// From four samples of x = Re(A·gᵏ), once parasitic roots have died out: x_{k+1} = (g + ḡ)·x_k −
// |g|²·x_{k−1}.
std::pair<double, double> amplification(const OscillatorMethod& method, double z) {
  soft::Motion m = oscillator_at(1, 0);
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

bool holds(const OscillatorMethod& method, double z, double zeta) {
  soft::Motion m = oscillator_at(1, 0);
  for (int i = 0; i < 40000; ++i) {
    method.advance(z, 1, zeta, 0, m);
    if (!(std::abs(m.x[0]) < 20)) return false;
  }
  return true;
}

}  // namespace prosector
