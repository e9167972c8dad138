// Trapezoidal rule up to γh, then the second-order backward difference through t, t + γh and t + h (Bank et
// al. 1985; Hosea & Shampine 1996). With γ = 2 − √2 both stages have the same c = γh/2.

#include <cmath>

#include "server/physics/mechanics/soft/integrators/implicit_integrators.h"

namespace prosector::soft {
namespace {

const double gamma = 2 - std::sqrt(2.0);

/// Between steps the history stores the last acceleration as the velocity from which it would have led to the
/// present one: v_prev = v − h·a. It includes all forces, contacts too.
class TrBdf2 final : public TimeIntegrator {
 public:
  int stages() const override { return 2; }
  double share(int stage_index) const override { return stage_index == 0 ? gamma : 1 - gamma; }
  bool remembers() const override { return true; }

  void begin(int stage_index, double h, const Weight& weight, const Motion& motion,
             Stage& stage) const override {
    if (stage_index == 0 && !motion.has_history) {  // the acceleration is unknown: backward Euler
      stage.x_v = motion.x;
      stage.y = motion.v;
      finish_inertia_target(gamma * h, weight, stage);
      return;
    }
    const double c = gamma * h / 2;
    if (stage_index == 0) {
      stage.x_v = motion.x + c * motion.v;
      stage.y = motion.v + gamma / 2 * (motion.v - motion.v_prev);
    } else {
      const double now = 1 / (gamma * (2 - gamma)), before = (1 - gamma) * (1 - gamma) * now;
      stage.x_v = now * motion.x - before * motion.x_prev;
      stage.y = now * motion.v - before * motion.v_prev;
    }
    stage.v_h = stage.y;
    finish_inertia_target(c, weight, stage);
  }

  void finish(int stage_index, double h, const Stage& stage, const Eigen::Ref<const VecX>& x,
              Motion& motion) const override {
    advance(stage, x, motion);
    if (stage_index == 0) return;
    motion.v_prev = motion.v - h * (motion.v - stage.v_h) / stage.dxdv;
  }
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_tr_bdf2() {
  return std::make_unique<TrBdf2>();
}

}  // namespace prosector::soft
