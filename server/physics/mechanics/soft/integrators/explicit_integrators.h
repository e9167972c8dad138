#pragma once
// Explicit time integrators: advance x and v by one substep from forces at known positions. A substep needs
// one to four force evaluations and no linear solve. It is stable only below a step size that the highest
// frequency determines.

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector::soft {

/// Acceleration of a body's nodes as a function of node positions and velocities: the interface by which
/// explicit integrators evaluate forces.
class AccelerationField {
 public:
  virtual ~AccelerationField() = default;
  /// Computes the node accelerations `a` (3n, m/s²) at node positions x (3n, m) and velocities v (3n, m/s).
  virtual void at(const VecX& x, const VecX& v, VecX& a) = 0;
  /// Returns whether the acceleration depends on the velocities, that is, whether there is damping.
  virtual bool damped() const = 0;
};

class ExplicitIntegrator {
 public:
  virtual ~ExplicitIntegrator() = default;
  /// Advances the node positions x (3n, m) and velocities v (3n, m/s) by one step of h s, with accelerations
  /// from `field`. Allocates memory at the first call only.
  virtual void step(AccelerationField& field, double h, VecX& x, VecX& v) = 0;
};

/// Row of the table of explicit integrators: a value of `integrator` in a scene file, its help text, its
/// order of accuracy and its factory.
struct ExplicitRow {
  const char* name;
  const char* help;
  int order;
  std::unique_ptr<ExplicitIntegrator> (*make)();
};
const std::vector<ExplicitRow>& explicit_integrators();

/// Stability limit of an explicit integrator: the largest stable time step for an oscillator, found by
/// bisection from the integrator's amplification matrix.
class StepLimit {
 public:
  /// Stores a reference to the integrator whose limit is computed. It must outlive this object and must not
  /// step anything else, since its buffers are sized for one oscillator.
  explicit StepLimit(ExplicitIntegrator& method);
  /// Returns the largest time step (s) at which the integrator does not amplify the oscillation x″ = −ω²x −
  /// (damping_mass + damping_stiffness·ω²)x′; 0 if it amplifies it at every step. `omega`: angular frequency
  /// ω, 1/s. For these integrators, a body's highest frequency limits its step, with or without damping.
  /// Allocates memory at the first call only.
  double at(double omega, double damping_mass = 0, double damping_stiffness = 0);

 private:
  double growth(AccelerationField& oscillator, double z);

  ExplicitIntegrator& method_;
  VecX x_, v_;  // 2 entries each
};

}  // namespace prosector::soft
