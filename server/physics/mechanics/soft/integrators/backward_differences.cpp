// Backward differentiation formulas (Gear 1971) of order 1 (implicit Euler) and 2.

#include "server/physics/mechanics/soft/integrators/implicit_integrators.h"

namespace prosector::soft {
namespace {

class BackwardDifferences final : public TimeIntegrator {
 public:
  explicit BackwardDifferences(int order) : order_(order) {}

  int stages() const override { return 1; }
  bool remembers() const override { return order_ > 1; }

  void begin(int, double h, const Weight& weight, const Motion& motion, Stage& stage) const override {
    if (order_ == 2 && motion.has_history) {
      stage.x_v = (4 * motion.x - motion.x_prev) / 3;
      stage.y = (4 * motion.v - motion.v_prev) / 3;
      finish_inertia_target(2 * h / 3, weight, stage);
    } else {
      stage.x_v = motion.x;
      stage.y = motion.v;
      finish_inertia_target(h, weight, stage);
    }
  }

  void finish(int, double, const Stage& stage, const Eigen::Ref<const VecX>& x,
              Motion& motion) const override {
    advance(stage, x, motion);
  }

 private:
  int order_;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_implicit_euler() {
  return std::make_unique<BackwardDifferences>(1);
}

std::unique_ptr<TimeIntegrator> make_bdf2() {
  return std::make_unique<BackwardDifferences>(2);
}

}  // namespace prosector::soft
