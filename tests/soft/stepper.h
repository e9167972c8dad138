#pragma once
// Steps one free soft body: projected Newton with a line search. The server's island solver does this for
// many bodies and contacts; tests need just this much.

#include <cmath>
#include <vector>

#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {

class BodyOperator final : public soft::LinearOperator {
 public:
  explicit BodyOperator(soft::SoftBody& body)
      : potential_(body.potential()), nodes_(body.nodes()), diagonal_(blocks()), inverse_(blocks()) {}
  void update() {
    potential_.diagonal(diagonal_);
    for (std::size_t i = 0; i < blocks(); ++i) inverse_[i] = diagonal_[i].inverse();
  }
  Eigen::Index size() const override { return 3 * nodes_; }
  void multiply(const VecX& p, VecX& Hp) const override { potential_.multiply(p.data(), Hp.data()); }
  void block_jacobi(const VecX& r, VecX& z) const override {
    for (Eigen::Index i = 0; i < nodes_; ++i) {
      z.segment<3>(3 * i) = inverse_[static_cast<std::size_t>(i)] * r.segment<3>(3 * i);
    }
  }
  void elastic_factor(const VecX& r, VecX& z) const override { potential_.factor_solve(r.data(), z.data()); }
  void multigrid(const VecX& r, VecX& z) const override {
    potential_.multigrid_solve(diagonal_, inverse_, r.data(), z.data());
  }

 private:
  std::size_t blocks() const { return static_cast<std::size_t>(nodes_); }
  soft::IncrementalPotential& potential_;
  Eigen::Index nodes_;
  std::vector<Mat3> diagonal_, inverse_;
};

struct StepperSettings {
  int newton_iterations = 50;
  double tolerance = 1e-10;  // on ‖gradient‖ relative to the step's first
  soft::SolverSettings solver = {2000, 1e-8};
};

class Stepper {
 public:
  explicit Stepper(soft::SoftBody& body, StepperSettings settings = {})
      : body_(body),
        potential_(body.potential()),
        stepper_(body.stepper()),
        settings_(settings),
        H_(body),
        solver_(soft::make_solver(body.desc().configuration.solver)) {}

  /// Newton iterations taken.
  int step(double h, const Vec3& gravity, soft::SoftBodyState& state) {
    int iterations = 0;
    for (int stage = 0; stage < stepper_.integrator().stages(); ++stage) {
      stepper_.begin_stage(stage, h, body_.weight(gravity, body_.attached()), state);
      VecX x = state.motion.x;
      iterations += minimise(x);
      stepper_.finish_stage(stage, h, x, state);
    }
    return iterations;
  }

  /// Steps so long that inertia vanishes: the static equilibrium.
  void settle(const Vec3& gravity, soft::SoftBodyState& state, int steps = 4, double h = 100) {
    for (int i = 0; i < steps; ++i) {
      step(h, gravity, state);
      state.motion.v.setZero();
      state.motion.has_history = false;
    }
  }

 private:
  int minimise(VecX& x) {
    VecX g(x.size()), dx = VecX::Zero(x.size()), trial(x.size());
    double first = 0;
    for (int iteration = 0; iteration < settings_.newton_iterations; ++iteration) {
      potential_.gradient(x, g);
      if (iteration == 0) first = g.norm();
      if (g.norm() <= settings_.tolerance * first) return iteration;
      potential_.assemble(x);
      H_.update();
      dx.setZero();
      solver_->solve(H_, -g, settings_.solver, dx);
      if (!line_search(x, g, dx, trial)) return iteration + 1;
    }
    return settings_.newton_iterations;
  }

  /// Armijo, up to the energy's rounding; false when no descent is left.
  bool line_search(VecX& x, const VecX& g, const VecX& dx, VecX& trial) {
    const double start = potential_.energy(x), slope = g.dot(dx);
    const double rounding = 1e-13 * std::abs(start);
    for (double t = 1; t > 1e-6; t /= 2) {
      trial = x + t * dx;
      if (potential_.energy(trial) <= start + 1e-4 * t * slope + rounding) {
        x = trial;
        return true;
      }
    }
    return false;
  }

  soft::SoftBody& body_;
  soft::IncrementalPotential& potential_;
  soft::ImplicitStepper& stepper_;
  StepperSettings settings_;
  BodyOperator H_;
  std::unique_ptr<soft::LinearSolver> solver_;
};

}  // namespace prosector
