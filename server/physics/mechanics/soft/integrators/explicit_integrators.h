#pragma once
// Explicit time integrators: advance x and v by one substep from forces at known positions. A substep needs
// one to four force evaluations and no linear solve. It is stable only below a step size that the highest
// frequency determines.

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Acceleration of the nodes as a function of positions and velocities.
class AccelerationField {
 public:
  virtual ~AccelerationField() = default;
  /// Computes the acceleration, m/s², into `a`; all vectors are 3n.
  virtual void at(const VecX& x, const VecX& v, VecX& a) = 0;
  /// Returns whether the acceleration depends on v.
  virtual bool damped() const = 0;
};

class ExplicitIntegrator {
 public:
  virtual ~ExplicitIntegrator() = default;
  /// Advances x, v (3n: m, m/s) by h s. Allocates on the first call only.
  virtual void step(AccelerationField& field, double h, VecX& x, VecX& v) = 0;
};

/// Row of the table of explicit integrators: `integrator` in a scene file.
struct ExplicitRow {
  const char* name;
  const char* help;
  int order;
  std::unique_ptr<ExplicitIntegrator> (*make)();
};
const std::vector<ExplicitRow>& explicit_integrators();

/// Stability limit of an explicit method, computed from its amplification matrix.
class StepLimit {
 public:
  /// Takes the method, which must outlive this object and must not step anything else: its buffers are sized
  /// for one oscillator.
  explicit StepLimit(ExplicitIntegrator& method);
  /// Returns the largest step, s, at which the oscillation x″ = −ω²x − (damping_mass +
  /// damping_stiffness·ω²)x′ does not grow; 0 if it grows at every step. For these methods the oscillation
  /// with the largest ω, 1/s, limits a body's step, with or without damping. Allocates memory at the first
  /// call only.
  double at(double omega, double damping_mass = 0, double damping_stiffness = 0);

 private:
  double growth(AccelerationField& oscillator, double z);

  ExplicitIntegrator& method_;
  VecX x_, v_;  // 2 entries each
};

}  // namespace prosector
