#include "server/physics/soft/implicit_integrators.h"

namespace prosector {
namespace {

class ImplicitEuler final : public TimeIntegrator {
 public:
  int stages() const override { return 1; }

  void begin(int, double h, const Vec3& gravity, const Motion& motion, Stage& stage) const override {
    stage.x_v = motion.x;
    stage.y = motion.v;
    finish_inertia_target(h, gravity, stage);
  }

  void finish(int, double, const Stage& stage, const Eigen::Ref<const VecX>& x,
              Motion& motion) const override {
    advance(stage, x, motion);
  }
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_implicit_euler() {
  return std::make_unique<ImplicitEuler>();
}

}  // namespace prosector
