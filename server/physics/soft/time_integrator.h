#pragma once
// Time integrators as stages of a minimisation, so that an island of several bodies can be solved as one.

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

/// The part of a soft body's state that integrators read and write; everything here is saved and hashed.
struct Motion {
  VecX x, v;                 // 3n: metres, m/s
  VecX x_prev, v_prev;       // one step ago, for multistep methods
  bool has_history = false;  // false after a start, a cut or a reset: multistep methods restart
};

/// The next x minimises  alpha/2·‖x − y‖²_M + W(x) + ½/h_d·‖x − x_n‖²_{C} − external work.
struct Stage {
  double alpha = 0;  // 1/s²: 1/h² for implicit Euler
  VecX y;            // 3n, m: where inertia (and gravity) alone would take the nodes
  double dxdv = 0;   // s: velocity after the step is (x − y_v)/dxdv, and h_d of the damping term
};

class TimeIntegrator {
 public:
  virtual ~TimeIntegrator() = default;
  virtual int stages() const = 0;
  /// `h` s, `gravity` m/s² (zero for bodies without). Writes into `stage` without allocating once sized.
  virtual void begin(int stage_index, double h, const Vec3& gravity, const Motion& motion,
                     Stage& stage) const = 0;
  /// Takes the minimiser x of the stage into the motion.
  virtual void finish(int stage_index, double h, const Stage& stage, const VecX& x, Motion& motion) const = 0;
};

struct IntegratorRow {
  const char* name;
  const char* help;
  std::unique_ptr<TimeIntegrator> (*make)();
};
const std::vector<IntegratorRow>& integrators();
std::unique_ptr<TimeIntegrator> make_integrator(const std::string& name);

}  // namespace prosector
