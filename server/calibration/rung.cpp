#include "server/calibration/rung.h"

#include <fmt/format.h>

#include "server/physics/mechanics/coupled/recovery.h"
#include "server/physics/mechanics/coupled/step_island.h"
#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

SoftDesc describe(const Rung& rung, const TestPiece& piece) {
  SoftDesc desc;
  desc.name = "specimen";
  rung.apply_to(desc);
  desc.material.youngs_modulus = piece.youngs_modulus;
  desc.material.poisson_ratio = piece.poisson_ratio;
  desc.material.density = piece.density;
  desc.material.damping_mass = piece.damping_mass;
  desc.material.damping_stiffness = piece.damping_stiffness;
  if (piece.clamped_axis >= 0) {
    constexpr double far = 1e6;  // m: a sphere so large that its surface is a plane to within 0.1 µm here
    desc.attach.push_back({-far * Vec3::Unit(piece.clamped_axis), far + 1e-6, piece.hold_stiffness});
  }
  if (piece.stiffness_ratio != 1) {
    const Vec3 size = piece.mesh.positions.back();
    RegionDesc half;
    half.center = Vec3(0.75 * size[0], size[1] / 2, size[2] / 2);
    half.size = Vec3(size[0] / 2, 2 * size[1], 2 * size[2]);
    half.youngs_modulus = piece.stiffness_ratio * piece.youngs_modulus;
    desc.material.regions.push_back(half);
  }
  if (piece.held_point) desc.attach.push_back({*piece.held_point, 1e-6, piece.hold_stiffness});
  return desc;
}

Anatomy anatomy_of(const TestPiece& piece) {
  Anatomy out;
  out.tets = piece.mesh;
  out.quads = piece.quads;
  out.segments = piece.segments;
  out.thickness = piece.thickness;
  return out;
}

/// A specimen that is stepped as the server steps a body, in a separate island.
class RungSpecimen final : public Specimen {
 public:
  RungSpecimen(const Rung& rung, const TestPiece& piece)
      : body_(describe(rung, piece), anatomy_of(piece)), state_(body_.initial_state()) {
    state_.asleep = false;
    island_.soft.push_back({0, &body_, &state_});
  }

  std::size_t elements() const override { return body_.elements(); }
  const VecX& node_mass() const override { return body_.node_mass(); }
  VecX rest() const override { return body_.initial_state().motion.x; }
  VecX positions() const override { return state_.motion.x; }
  VecX velocities() const override { return state_.motion.v; }

  void set_motion(const VecX& x, const VecX& v) override {
    state_ = body_.initial_state();
    state_.asleep = false;
    state_.motion.x = x;
    state_.motion.v = v;
  }

  StepFigures step(double dt, const Vec3& gravity) override {
    const coupled::IslandReport report = stepper_.step(island_, dt, gravity);
    coupled::SoftMember& member = island_.soft.front();
    StepFigures figures;
    figures.residual = report.residual;
    figures.solver_iterations = report.solver_iterations;
    figures.converged = report.converged || member.substeps > 0;
    figures.reported = member.degraded;
    figures.refused = member.refused;
    figures.guarded = member.guarded;
    figures.recovering = state_.recovering;
    if (!report.finite) {
      // As the server does for a body out of bounds: it returns to its last good state, at rest.
      const VecX x = state_.motion.x;
      set_motion(x, VecX::Zero(x.size()));
      figures.reset = true;
      member.note =
          "the body's positions were not finite or out of the room: reset to its last valid state, at rest";
    }
    coupled::count_quiet_ticks(member);
    const bool laden = !gravity.isZero();  // its rest shape under load differs from its initial shape
    if (coupled::unfold_if_tangled(member, {.crushed = laden, .company = laden},
                                   body_.initial_state().motion.x, dt, 1))
      figures.reset = true;
    figures.note = member.note;
    return figures;
  }

  double weight_energy(const Vec3& gravity) const override {
    const VecX& x = state_.motion.x;
    return -soft::fall_energy(body_.node_mass(), VecX::Zero(x.size()), x,
                              body_.weight(gravity, body_.attached()));
  }
  double elastic_energy() override {
    return body_.in_force(state_).potential().elastic_energy(state_.motion.x);
  }

 private:
  soft::SoftBody body_;
  soft::SoftBodyState state_;
  coupled::Island island_;
  coupled::IslandStepper stepper_;
};

}  // namespace

void Rung::apply_to(SoftDesc& desc) const {
  desc.configuration.model = model;
  desc.configuration.element = element;
  desc.configuration.integrator = integrator;
  desc.configuration.solver = solver;
  desc.configuration.newton_iterations = newton_iterations;
  desc.configuration.solver_iterations = solver_iterations;
  desc.configuration.solver_tolerance = solver_tolerance;
  desc.configuration.substeps = substeps;
}

bool Rung::is_position_based() const {
  return soft::find_row(soft::models(), "model", model).position_based;
}

std::string Rung::effort() const {
  if (is_position_based()) return fmt::format("{} substeps", substeps);
  if (solver == "direct") return fmt::format("{} Newton", newton_iterations);
  return fmt::format("{} × {} to {:.0e}", newton_iterations, solver_iterations, solver_tolerance);
}

std::string Rung::name() const {
  if (is_position_based()) return model + ", " + element;
  return model + ", " + element + ", " + integrator + ", " + solver;
}

std::unique_ptr<Specimen> make_specimen(const Rung& rung, const TestPiece& piece) {
  return std::make_unique<RungSpecimen>(rung, piece);
}

}  // namespace prosector
