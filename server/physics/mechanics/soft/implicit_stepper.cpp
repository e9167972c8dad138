#include "server/physics/mechanics/soft/implicit_stepper.h"

namespace prosector::soft {

ImplicitStepper::ImplicitStepper(const SoftMatter& matter, IncrementalPotential& potential, bool substepped)
    : matter_(matter),
      potential_(potential),
      euler_(make_integrator("implicit_euler")),
      integrator_(make_integrator(substepped ? "implicit_euler" : matter.desc.configuration.integrator)) {
  reset();
}

void ImplicitStepper::reset() {
  stepping_ = integrator_.get();
  relaxed_ = false;
  history_ = {};
  Stage& stage = potential_.stage();
  for (VecX* v : {&x_n_, &stage.y, &stage.x_v, &stage.v_h, &remembered_.x, &remembered_.v})
    v->setZero(matter_.rest().size());
}

void ImplicitStepper::begin_stage(int stage_index, double h, const Weight& weight, const SoftBodyState& state,
                                  bool euler) {
  stepping_ = euler ? euler_.get() : integrator_.get();
  stepping_->begin(stage_index, h, weight, state.motion, potential_.stage());
  x_n_ = state.motion.x;
  potential_.begin_stage(x_n_);
  if (relaxed_)
    matter_.model->relax_fully();
  else
    matter_.model->begin_step(stepping_->share(stage_index) * h, x_n_.data(), state.history.data());
}

void ImplicitStepper::initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const {
  if (stepping_->stages() == 1)
    x = state.motion.x + h * state.motion.v + state.warm_start;
  else
    x = stage().x_v + stage().dxdv * state.motion.v;
}

void ImplicitStepper::finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x,
                                   SoftBodyState& state) const {
  if (stage_index == 0) state.warm_start = -h * state.motion.v;
  stepping_->finish(stage_index, h, stage(), x, state.motion);
  if (!relaxed_) matter_.model->end_step(x.data(), state.history.data());
  if (stage_index + 1 == stepping_->stages()) state.warm_start += h * state.motion.v;
}

void ImplicitStepper::remember(const SoftBodyState& state) {
  remembered_.x = state.motion.x;
  remembered_.v = state.motion.v;
  history_ = state.history;
}

void ImplicitStepper::recall(SoftBodyState& state) const {
  state.motion.x = remembered_.x;
  state.motion.v = remembered_.v;
  state.history = history_;
  state.motion.has_history = false;
  state.warm_start.setZero();
}

}  // namespace prosector::soft
