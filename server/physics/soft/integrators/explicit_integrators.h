#pragma once
// Explicit time integrators: x and v one substep on from forces at places already known. They cost one to
// four force evaluations and no solve, and hold only below a step that the stiffest oscillation sets.

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

/// What moves the nodes, as a function of where they are and how fast they go.
class AccelerationField {
 public:
  virtual ~AccelerationField() = default;
  /// Computes the acceleration, m/s², into `a`; all 3n.
  virtual void at(const VecX& x, const VecX& v, VecX& a) = 0;
  /// Tells whether the acceleration depends on v.
  virtual bool damped() const = 0;
};

class ExplicitIntegrator {
 public:
  virtual ~ExplicitIntegrator() = default;
  /// Advances x, v (3n: m, m/s) by h s. Allocates on the first call only.
  virtual void step(AccelerationField& field, double h, VecX& x, VecX& v) = 0;
};

/// One row of the table: `integrator` in a scene file.
struct ExplicitRow {
  const char* name;
  const char* help;
  int order;
  std::unique_ptr<ExplicitIntegrator> (*make)();
};
const std::vector<ExplicitRow>& explicit_integrators();

/// How long steps a method may take, from its own amplification matrix.
class StepLimit {
 public:
  /// Takes the method, which must outlive this and step nothing else: its memory is for one oscillation.
  explicit StepLimit(ExplicitIntegrator& method);
  /// Returns the largest step, s, at which the oscillation x″ = −ω²x − (damping_mass +
  /// damping_stiffness·ω²)x′ does not grow; 0 when it grows at every step. Of a body's oscillations the one
  /// with the largest ω, 1/s, bounds the step, with damping as without. What grows faster with ω than the
  /// growth itself is none of the methods' margins. Allocates on the first call only.
  double at(double omega, double damping_mass = 0, double damping_stiffness = 0);

 private:
  double growth(AccelerationField& oscillator, double z);

  ExplicitIntegrator& method_;
  VecX x_, v_;  // 2
};

}  // namespace prosector
