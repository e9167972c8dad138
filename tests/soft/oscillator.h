#pragma once
// Every integrator by itself, no substepping and no guard around it, on the oscillator x″ = −ω²x − 2ζωx′ + g,
// whose order, amplification and limit are known.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/physics/mechanics/soft/integrators/explicit_integrators.h"
#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector {

/// Three equal oscillators of unit mass at x m, v m/s.
soft::Motion oscillator_at(double x, double v);

/// One method of either table.
struct OscillatorMethod {
  std::string name;
  int order;
  std::shared_ptr<soft::TimeIntegrator> stages;  // one of these two
  std::shared_ptr<soft::ExplicitIntegrator> forces;

  /// One step of h s; omega 1/s, g m/s².
  void advance(double h, double omega, double zeta, double g, soft::Motion& motion) const;
};

std::vector<OscillatorMethod> oscillator_methods();
/// Throws std::out_of_range.
OscillatorMethod oscillator_method(const std::string& name);

/// Observed order: after 0.3 s of ω = 2π/s, since after a whole period an error of phase hides.
double observed_order(const OscillatorMethod& method, double zeta);

/// |g| per step and arg(g)/z, the frequency in parts of the exact one, of the undamped oscillator at ωh = z.
std::pair<double, double> amplification(const OscillatorMethod& method, double z);

/// Whether 40,000 steps of ωh = z keep x bounded: next to the limit it beats up to some times its start.
bool holds(const OscillatorMethod& method, double z, double zeta = 0);

}  // namespace prosector
