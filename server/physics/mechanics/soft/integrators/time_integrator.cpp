#include "server/physics/mechanics/soft/integrators/time_integrator.h"

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/integrators/implicit_integrators.h"

namespace prosector::soft {

const std::vector<IntegratorRow>& integrators() {
  static const std::vector<IntegratorRow> rows = {
      {"implicit_euler", "implicit integrator of first order with strong numerical damping; the most robust",
       1, make_implicit_euler},
      {"bdf2",
       "implicit integrator of second order with little numerical damping; its first step is by "
       "implicit_euler",
       2, make_bdf2},
      {"tr_bdf2",
       "implicit integrator of second order at twice the cost; conserves the energy of motions that a tick "
       "resolves",
       2, make_tr_bdf2},
  };
  return rows;
}

std::unique_ptr<TimeIntegrator> make_integrator(const std::string& name) {
  return find_row(integrators(), "integrator", name).make();
}

void finish_inertia_target(double c, const Weight& weight, Stage& stage) {
  stage.alpha = 1 / (c * c);
  stage.dxdv = c;
  stage.y = stage.x_v + c * stage.y;
  weight.add(c * c, stage.y);
}

void advance(const Stage& stage, const Eigen::Ref<const VecX>& x, Motion& motion) {
  motion.x_prev = motion.x;
  motion.v_prev = motion.v;
  motion.v = (x - stage.x_v) / stage.dxdv;
  motion.x = x;
  motion.has_history = true;
}

}  // namespace prosector::soft
