#pragma once
// Time integrators as stages of a minimisation, so that an island of several bodies can be solved as one.
//
// M·v̇ = M·g − ∂W/∂x − C·v, ẋ = v. An implicit stage closes with
//   x = x_v + c·v,   v = v_h + c·a(x)        (c: `dxdv`; x_v, v_h: combinations of past states)
// and thus minimises
//   E(x) = α/2·‖x − y‖²_M + W(x) + 1/(2c)·‖x − x_v‖²_C,   α = 1/c²,   y = x_v + c·v_h + c²·g;
// its velocity is v = (x − x_v)/c. Gravity is in y, so that ‖x − y‖ is what forces other than gravity do.
//   implicit Euler: c = h,     x_v = x_n,                v_h = v_n
//   BDF2:           c = 2h/3,  x_v = (4x_n − x_{n−1})/3, v_h = (4v_n − v_{n−1})/3
//   TR-BDF2:        c = γh/2,  x_v = x_n + c·v_n,        v_h = v_n + c·a_n, then with x_γ, v_γ so found
//                   c = γh/2,  x_v = (x_γ − (1−γ)²x_n)/(γ(2−γ)),
//                              v_h = (v_γ − (1−γ)²v_n)/(γ(2−γ));   γ = 2 − √2
// (Gear 1971; Bank et al. 1985; as a minimisation: Gast et al. 2015.)
//
// Why TR-BDF2 is the energy-faithful one here: at z = ωh = ½ it damps 40 times less than BDF2. Yet it is
// L-stable, so that contacts and stiff modes that a tick cannot resolve die out instead of ringing. The
// implicit midpoint and trapezoid rules lose nothing at all, and for that reason blow up in nonlinear bodies
// at large steps (Simo & Tarnow 1992). The midpoint moreover extrapolates past the state that was solved
// for, and with it past every contact.

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"
#include "server/physics/soft/base/weight.h"

namespace prosector {

/// The part of a soft body's state that integrators read and write; everything here is saved and hashed.
struct Motion {
  VecX x, v;            // 3n: metres, m/s
  VecX x_prev, v_prev;  // one step ago, for multistep methods
  /// False after a start, a cut or a reset: multistep methods restart. Whoever changes h, x or v from
  /// outside sets it to false.
  bool has_history = false;
};

/// What a stage minimises, see above.
struct Stage {
  double alpha = 0;  // 1/s²
  double dxdv = 0;   // s: c
  VecX y;            // 3n, m: where inertia and gravity alone would take the nodes
  VecX x_v;          // 3n, m: the velocity after the stage is (x − x_v)/dxdv
  VecX v_h;          // 3n, m/s: written by methods whose next step needs the acceleration (v − v_h)/dxdv
};

class TimeIntegrator {
 public:
  virtual ~TimeIntegrator() = default;
  virtual int stages() const = 0;
  /// Returns what share of the step's time the stage covers.
  virtual double share(int /*stage_index*/) const { return 1; }
  /// Tells whether a step depends on what was before its start.
  virtual bool remembers() const = 0;
  /// Begins a stage of a step of `h` s. Writes into `stage` without allocating once sized.
  virtual void begin(int stage_index, double h, const Weight& weight, const Motion& motion,
                     Stage& stage) const = 0;
  /// Takes the minimiser x of the stage into the motion; after the last stage the step is done.
  virtual void finish(int stage_index, double h, const Stage& stage, const Eigen::Ref<const VecX>& x,
                      Motion& motion) const = 0;
};

struct IntegratorRow {
  const char* name;
  const char* help;
  int order;
  std::unique_ptr<TimeIntegrator> (*make)();
};
const std::vector<IntegratorRow>& integrators();
/// Throws InputError that lists the names there are.
std::unique_ptr<TimeIntegrator> make_integrator(const std::string& name);

}  // namespace prosector
