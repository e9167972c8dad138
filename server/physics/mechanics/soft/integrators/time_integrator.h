#pragma once
// Time integrators as stages of a minimisation, so that an island of several bodies can be solved together.
//
// M·v̇ = M·g − ∂W/∂x − C·v, ẋ = v. An implicit stage closes with
//   x = x_v + c·v,   v = v_h + c·a(x)        (c: `dxdv`; x_v, v_h: combinations of past states)
// and thus minimises
//   E(x) = α/2·‖x − y‖²_M + W(x) + 1/(2c)·‖x − x_v‖²_C,   α = 1/c²,   y = x_v + c·v_h + c²·g;
// its velocity is v = (x − x_v)/c. Gravity is included in y, so ‖x − y‖ is due to the other forces.
//   implicit Euler: c = h,     x_v = x_n,                v_h = v_n
//   BDF2:           c = 2h/3,  x_v = (4x_n − x_{n−1})/3, v_h = (4v_n − v_{n−1})/3
//   TR-BDF2:        c = γh/2,  x_v = x_n + c·v_n,        v_h = v_n + c·a_n, which gives x_γ, v_γ; then
//                   c = γh/2,  x_v = (x_γ − (1−γ)²x_n)/(γ(2−γ)),
//                              v_h = (v_γ − (1−γ)²v_n)/(γ(2−γ));   γ = 2 − √2
// (Gear 1971; Bank et al. 1985; as a minimisation: Gast et al. 2015.)
//
// TR-BDF2 is the integrator with the smallest energy loss here: at z = ωh = ½ it damps 40 times less than
// BDF2. It is L-stable, so contacts and stiff modes that a tick cannot resolve decay instead of ringing. The
// implicit midpoint and trapezoidal rules lose no energy, and therefore become unstable for nonlinear bodies
// at large steps (Simo & Tarnow 1992). The midpoint rule also extrapolates beyond the solved state, and thus
// beyond all contacts.

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/soft/base/weight.h"

namespace prosector::soft {

/// Positions and velocities of a soft body's nodes, now and one step before: the part of its state that
/// integrators read and write. All of it is saved in checkpoints and hashed.
struct Motion {
  VecX x, v;            // 3n: metres, m/s
  VecX x_prev, v_prev;  // one step before, for multistep methods
  /// Whether `x_prev` and `v_prev` hold the previous step. False after a start, a cut or a reset, so that
  /// multi-step integrators restart. Code outside the integrators that changes the step length, x or v must
  /// set it to false.
  bool has_history = false;
};

/// Parameters of the function E(x) = α/2·‖x − y‖²_M + W(x) + 1/(2c)·‖x − x_v‖²_C that a stage of an implicit
/// step minimises over node positions x. Masses M, damping matrix C and elastic energy W are the body's.
struct Stage {
  double alpha = 0;  // 1/s²
  double dxdv = 0;   // s: c
  VecX y;            // 3n, m: positions under inertia and gravity alone
  VecX x_v;          // 3n, m: the velocity after the stage is (x − x_v)/dxdv
  VecX v_h;          // 3n, m/s: written by methods whose next step needs the acceleration (v − v_h)/dxdv
};

class TimeIntegrator {
 public:
  virtual ~TimeIntegrator() = default;
  virtual int stages() const = 0;
  /// Returns the fraction (0 to 1) of the step's time that the stage with this index covers.
  virtual double share(int /*stage_index*/) const { return 1; }
  /// Returns whether a step of this integrator depends on states before the step's start, as in multi-step
  /// methods.
  virtual bool remembers() const = 0;
  /// Computes the parameters of a stage (one minimisation) of a step of `h` s from the body's `motion` and
  /// its `weight`, and writes them to `stage`. Allocates no memory once the vectors of `stage` have their
  /// size.
  virtual void begin(int stage_index, double h, const Weight& weight, const Motion& motion,
                     Stage& stage) const = 0;
  /// Stores the node positions x (3n, m) that minimise the stage's function in `motion`, with the velocities
  /// that follow from them. After the last stage the step is complete.
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
/// Creates the implicit integrator with this name. Throws InputError that lists the known names if there is
/// none.
std::unique_ptr<TimeIntegrator> make_integrator(const std::string& name);

}  // namespace prosector::soft
