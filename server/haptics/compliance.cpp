#include "server/haptics/compliance.h"

#include <algorithm>
#include <numbers>

#include "server/physics/mechanics/soft/body_on_springs.h"
#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector {
namespace {

constexpr soft::SolverSettings solve_settings = {60, 1e-2};
constexpr double slowest = 0.5;  // Hz: inertia at this frequency supports a body that nothing holds

/// Returns the description without damping. Solids are solved by multigrid; a sheet or a rope has no coarse
/// levels.
SoftDesc at_rest(SoftDesc desc, bool solid) {
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  desc.configuration.solver = solid ? "multigrid" : "cg";
  return desc;
}

soft::BodyOnSprings::Spring spring_of(const contact::ContactSide& side, const Mat3& stiffness) {
  soft::BodyOnSprings::Spring out{{}, stiffness};
  for (std::size_t k = 0; k < side.nodes; ++k)
    out.nodes.emplace_back(static_cast<Eigen::Index>(side.node[k]), side.weight[k]);
  return out;
}

void add(const contact::ContactSide& side, const Vec3& force, VecX& out) {
  for (std::size_t k = 0; k < side.nodes; ++k)
    out.segment<3>(3 * static_cast<Eigen::Index>(side.node[k])) += side.weight[k] * force;
}

Vec3 moved(const contact::ContactSide& side, const VecX& u) {
  Vec3 out = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k)
    out += side.weight[k] * u.segment<3>(3 * static_cast<Eigen::Index>(side.node[k]));
  return out;
}

}  // namespace

struct TissueCompliance::Solver {
  Solver(const soft::SoftMatter& matter, Eigen::Index nodes)
      : potential(matter),
        hessian(potential, nodes),
        solver(soft::make_solver(matter.desc.configuration.solver)) {}
  soft::IncrementalPotential potential;
  soft::BodyOnSprings hessian;
  std::unique_ptr<soft::LinearSolver> solver;

  /// Returns the growth of the force on `patch`, N/m, as a hand moves by the unit vector `e`. The hand's
  /// springs are the points of `pressing`. `holds`: include the friction springs.
  double slope(const std::vector<const Patch*>& pressing, const Patch& patch, const Vec3& e, bool holds,
               std::vector<soft::BodyOnSprings::Spring> springs, double strength) {
    const auto spring = [&](const Patch::Point& point) -> Mat3 {
      return holds ? Mat3(point.stiffness + point.holding) : point.stiffness;
    };
    VecX f = VecX::Zero(hessian.size()), u = f;
    for (const Patch* p : pressing)
      for (const Patch::Point& point : p->points) {
        add(point.side, spring(point) / strength * e, f);
        springs.push_back(spring_of(point.side, spring(point) / strength));
      }
    hessian.refresh(std::move(springs));
    solver->solve(hessian, f, solve_settings, u);
    double out = 0;
    for (const Patch::Point& point : patch.points) out += e.dot(spring(point) * (e - moved(point.side, u)));
    return out;
  }
};

TissueCompliance::TissueCompliance(const SoftDesc& desc, Anatomy anatomy, const VecX& ties)
    : matter_(
          std::make_unique<soft::SoftMatter>(at_rest(desc, !anatomy.tets.tets.empty()), std::move(anatomy))) {
  matter_->ties = ties;
  matter_->weigh();
  solver_ = std::make_unique<Solver>(*matter_, matter_->mass.size());
  matter_->model->relax_fully();
}
TissueCompliance::~TissueCompliance() = default;

std::vector<Slopes> TissueCompliance::find(const VecX& x, double strength,
                                           const std::vector<Support>& supports,
                                           const std::vector<Patch>& patches) {
  Solver& s = *solver_;
  soft::Stage& stage = s.potential.stage();
  stage.alpha = std::pow(2 * std::numbers::pi * slowest, 2);
  stage.dxdv = 1;
  stage.y = stage.x_v = x;
  s.potential.begin_stage(x);
  s.potential.assemble(x);
  std::vector<Slopes> out;
  for (const Patch& patch : patches) {
    std::vector<const Patch*> pressing;
    for (const Patch& other : patches)
      if (&other == &patch || (other.presses && other.hand == patch.hand)) pressing.push_back(&other);
    // Instead of multiplying the material's stiffness by `strength`, the springs' stiffness is divided by it.
    std::vector<soft::BodyOnSprings::Spring> springs;
    for (const Support& support : supports)
      springs.push_back(spring_of(support.side, support.stiffness / strength));
    out.push_back({s.slope(pressing, patch, patch.normal, false, springs, strength),
                   s.slope(pressing, patch, patch.normal.unitOrthogonal(), true, springs, strength)});
  }
  return out;
}

}  // namespace prosector
