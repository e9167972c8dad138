#include "server/haptics/compliance.h"

#include <algorithm>
#include <numbers>

#include "server/physics/soft/body_operator.h"
#include "server/physics/soft/soft_matter.h"

namespace prosector {
namespace {

constexpr SolverSettings solve_settings = {60,
                                           1e-2};  // on u; what is told is uᵀf, so its error is the square
constexpr double slowest = 0.5;  // Hz: what nothing holds is borne by its inertia at that frequency

SoftDesc at_rest(SoftDesc desc) {
  desc.damping_mass = desc.damping_stiffness = 0;
  desc.solver = "multigrid";
  return desc;
}

BodyOperator::Spring spring_of(const ContactSide& side, const Mat3& stiffness) {
  BodyOperator::Spring out{{}, stiffness};
  for (std::size_t k = 0; k < side.nodes; ++k)
    out.nodes.emplace_back(static_cast<Eigen::Index>(side.node[k]), side.weight[k]);
  return out;
}

/// Returns the load of one newton along `direction`, spread as the patch says.
VecX load_of(const Patch& patch, const Vec3& direction, Eigen::Index size) {
  VecX out = VecX::Zero(size);
  for (std::size_t i = 0; i < patch.points.size(); ++i)
    for (std::size_t k = 0; k < patch.points[i].nodes; ++k)
      out.segment<3>(3 * static_cast<Eigen::Index>(patch.points[i].node[k])) +=
          patch.weight[i] * patch.points[i].weight[k] * direction;
  return out;
}

}  // namespace

struct TissueCompliance::Solver {
  Solver(const SoftMatter& matter, Eigen::Index nodes)
      : potential(matter), hessian(potential, nodes), solver(make_solver(matter.desc.solver)) {}
  IncrementalPotential potential;
  BodyOperator hessian;
  std::unique_ptr<LinearSolver> solver;

  double give(const Patch& patch, const Vec3& direction) {
    const VecX f = load_of(patch, direction, hessian.size());
    VecX u = VecX::Zero(f.size());
    solver->solve(hessian, f, solve_settings, u);
    return u.dot(f);
  }
};

TissueCompliance::TissueCompliance(const SoftDesc& desc, Anatomy anatomy, const VecX& ties)
    : matter_(std::make_unique<SoftMatter>(at_rest(desc), std::move(anatomy))) {
  matter_->ties = ties;
  matter_->weigh();
  solver_ = std::make_unique<Solver>(*matter_, matter_->mass.size());
  matter_->model->relax_fully();
}
TissueCompliance::~TissueCompliance() = default;

std::vector<Compliance> TissueCompliance::find(const VecX& x, double stiffness,
                                               const std::vector<Support>& supports,
                                               const std::vector<Patch>& patches) {
  Solver& s = *solver_;
  // A material that is that many times as stiff is one whose supports are that many times as soft.
  std::vector<BodyOperator::Spring> springs;
  for (const Support& support : supports)
    springs.push_back(spring_of(support.side, support.stiffness / stiffness));
  Stage& stage = s.potential.stage();
  stage.alpha = std::pow(2 * std::numbers::pi * slowest, 2);
  stage.dxdv = 1;
  stage.y = stage.x_v = x;
  s.potential.begin_stage(x);
  s.potential.assemble(x);
  s.hessian.refresh(std::move(springs));
  std::vector<Compliance> out;
  for (const Patch& patch : patches) {
    const Vec3 along = patch.normal.unitOrthogonal();
    out.push_back({s.give(patch, patch.normal) / stiffness, s.give(patch, along) / stiffness});
  }
  return out;
}

}  // namespace prosector
