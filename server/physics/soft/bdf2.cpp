#include "server/physics/soft/implicit_integrators.h"

namespace prosector {
namespace {

class Bdf2 final : public TimeIntegrator {
 public:
  int stages() const override { return 1; }

  void begin(int, double h, const Vec3& gravity, const Motion& motion, Stage& stage) const override {
    if (motion.has_history) {
      stage.x_v = (4 * motion.x - motion.x_prev) / 3;
      stage.y = (4 * motion.v - motion.v_prev) / 3;
      finish_inertia_target(2 * h / 3, gravity, stage);
    } else {
      stage.x_v = motion.x;
      stage.y = motion.v;
      finish_inertia_target(h, gravity, stage);
    }
  }

  void finish(int, double, const Stage& stage, const Eigen::Ref<const VecX>& x,
              Motion& motion) const override {
    advance(stage, x, motion);
  }
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_bdf2() {
  return std::make_unique<Bdf2>();
}

}  // namespace prosector
