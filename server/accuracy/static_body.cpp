#include "server/accuracy/static_body.h"

#include <algorithm>
#include <cmath>

#include "server/accuracy/secants.h"
#include "server/physics/mechanics/soft/body_on_springs.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/soft_matter.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"
#include "server/physics/mechanics/soft/unfold.h"

namespace prosector {
namespace {

constexpr int most_newton_steps = 120;
constexpr int most_halvings = 30;
constexpr double armijo = 1e-4;
constexpr double settled_decrement = 1e-7;  // of the energy: predicted gain of a Newton step
constexpr double noise = 1e-13;             // of the energy: rounding error of differences
constexpr double most_inverted = 0.01;      // of the volume: more is no valid shape of tissue
constexpr soft::SolverSettings solve_settings = {400, 1e-4};

/// Returns the description without damping and with a fast solver, neither of which affects the shape at
/// rest.
SoftDesc undamped(SoftDesc desc) {
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  desc.configuration.solver = "multigrid";  // several times as fast here as a factorisation
  return desc;
}

}  // namespace

bool StaticAnswer::usable() const {
  return settled && inverted <= most_inverted;
}

/// Potential, Hessian and linear solver of the minimisation.
struct StaticBody::Newton {
  Newton(const soft::SoftMatter& matter, Eigen::Index nodes)
      : potential(matter),
        hessian(potential, nodes),
        solver(soft::make_solver(matter.desc.configuration.solver)) {}
  soft::IncrementalPotential potential;
  soft::BodyOnSprings hessian;
  std::unique_ptr<soft::LinearSolver> solver;

  VecX gradient(const VecX& x, const VecX& load) {
    VecX out(x.size());
    potential.gradient(x, out);
    return out - load;
  }
  VecX solve(const VecX& r) {
    VecX z = VecX::Zero(r.size());
    solver->solve(hessian, r, solve_settings, z);
    return z;
  }
  double energy(const VecX& x, const VecX& rest, const VecX& load) {
    return potential.energy(x) - load.dot(x - rest);
  }
};

StaticBody::StaticBody(const SoftDesc& desc, Anatomy anatomy) {
  matter_ = std::make_unique<soft::SoftMatter>(undamped(desc), std::move(anatomy));
  newton_ = std::make_unique<Newton>(*matter_, matter_->mass.size());
  described_ = matter_->ties;
  matter_->model->relax_fully();
  soft::Stage& stage = newton_->potential.stage();
  stage.dxdv = 1;
  stage.y = stage.x_v = matter_->rest();
}

StaticBody::~StaticBody() = default;
StaticBody::StaticBody(StaticBody&&) noexcept = default;

const TetMesh& StaticBody::mesh() const {
  return matter_->anatomy.tets;
}
const VecX& StaticBody::rest() const {
  return matter_->rest();
}
const VecX& StaticBody::mass() const {
  return matter_->mass;
}
const VecX& StaticBody::volume() const {
  return matter_->model->volume();
}
VecX StaticBody::weight(const Vec3& acceleration) const {
  return (matter_->desc.material.density * acceleration * matter_->model->shape_volume().transpose())
      .reshaped();
}
bool StaticBody::quadratic() const {
  return matter_->quadratic.has_value();
}

void StaticBody::tie(const VecX& stiffness) {
  matter_->ties = described_ + stiffness;
  matter_->weigh();
  newton_->potential.reweigh();
}

StaticAnswer StaticBody::settle(const VecX& load, const std::function<void()>& before_step) {
  Newton& n = *newton_;
  const VecX& rest = matter_->rest();
  StaticAnswer out;
  out.x = rest;
  n.potential.begin_stage(rest);
  Secants secants;
  VecX gradient = n.gradient(out.x, load);
  double energy = n.energy(out.x, rest, load);
  for (int i = 0; i < most_newton_steps && !out.settled; ++i) {
    if (before_step) before_step();
    n.potential.assemble(out.x);
    n.hessian.refresh();
    const VecX direction = secants.direction(gradient, [&](const VecX& r) { return n.solve(r); });
    const double slope = gradient.dot(direction);
    if (!direction.allFinite() || !(slope < 0)) break;
    VecX next;
    double found = 0, length = 1;
    for (int halvings = 0;; ++halvings, length /= 2) {
      next = out.x + length * direction;
      found = n.energy(next, rest, load);
      if (found <= energy + armijo * length * slope + noise * std::abs(energy)) break;
      if (halvings == most_halvings) return out;
    }
    const VecX next_gradient = n.gradient(next, load);
    secants.remember(next - out.x, next_gradient - gradient);
    out.settled = -slope < settled_decrement * std::abs(found);
    out.x = next;
    gradient = next_gradient;
    energy = found;
  }
  out.inverted = soft::inverted_share(matter_->linear_tets(), out.x);
  return out;
}

}  // namespace prosector
