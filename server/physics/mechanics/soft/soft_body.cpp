#include "server/physics/mechanics/soft/soft_body.h"

#include <utility>

#include "common/hash.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "server/physics/mechanics/soft/recovery_law.h"
#include "server/physics/mechanics/soft/soft_body_setup.h"
#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector::soft {
namespace {

std::unique_ptr<Substepper> substepper_of(const SoftMatter& m) {
  return name_in_errors(m.desc, [&] {
    return make_substepper({m.desc, *m.model, m.pattern, m.inertia, m.attached}, m.anatomy);
  });
}

}  // namespace

struct SoftBody::Parts {
  SoftMatter matter;
  IncrementalPotential potential;
  std::unique_ptr<Substepper> substepper;
  ImplicitStepper stepper;
  RecoveryLaw recovery;
  MeshFollower follower;

  Parts(const SoftDesc& desc, Anatomy anatomy)
      : matter(desc, std::move(anatomy)),
        potential(matter),
        substepper(substepper_of(matter)),
        stepper(matter, potential, substepper != nullptr),
        recovery(matter),
        follower({matter, potential, stepper, recovery, substepper}) {}
};

SoftBody::SoftBody(const SoftDesc& desc, Anatomy anatomy)
    : parts_(std::make_unique<Parts>(desc, std::move(anatomy))) {}
SoftBody::~SoftBody() = default;
SoftBody::SoftBody(SoftBody&&) noexcept = default;

const SoftDesc& SoftBody::desc() const {
  return parts_->matter.desc;
}
const Anatomy& SoftBody::anatomy() const {
  return parts_->matter.anatomy;
}
Eigen::Index SoftBody::nodes() const {
  return parts_->matter.mass.size();
}
std::size_t SoftBody::elements() const {
  return parts_->matter.model->connectivity().size();
}
std::size_t SoftBody::dropped_elements() const {
  return parts_->matter.model->dropped_elements();
}
const VecX& SoftBody::rest() const {
  return parts_->matter.rest();
}
double SoftBody::diagonal() const {
  return parts_->matter.diagonal;
}
const VecX& SoftBody::node_mass() const {
  return parts_->matter.mass;
}
double SoftBody::total_mass() const {
  return parts_->matter.mass.sum();
}
std::span<const double> SoftBody::surface_area() const {
  return parts_->matter.area;
}
const VecX& SoftBody::attachment_stiffness() const {
  return parts_->matter.ties;
}
const TetMesh& SoftBody::linear_tets() const {
  return parts_->matter.linear_tets();
}
bool SoftBody::objective() const {
  return parts_->matter.model->objective();
}

std::uint64_t SoftBody::content_hash() const {
  StateHasher hasher;
  const Anatomy& anatomy = parts_->matter.anatomy;
  const VecX &rest = parts_->matter.rest(), &mass = parts_->matter.mass;
  hasher.add(anatomy.tets.positions.size());
  hasher.add(anatomy.tets.tets.size());
  hasher.add(std::as_bytes(std::span(anatomy.tets.tets)));
  hasher.add(std::as_bytes(std::span(anatomy.quads)));
  hasher.add(std::as_bytes(std::span(anatomy.triangles)));
  hasher.add(std::as_bytes(std::span(anatomy.segments)));
  hasher.add(rest.data(), static_cast<std::size_t>(rest.size()));
  hasher.add(mass.data(), static_cast<std::size_t>(mass.size()));
  return hasher.digest();
}

SoftBodyState SoftBody::initial_state() const {
  SoftBodyState state;
  const VecX still = VecX::Zero(rest().size());
  state.motion = {rest(), still, rest(), still, false};
  state.warm_start = still;
  state.history = VecX::Zero(static_cast<Eigen::Index>(parts_->matter.model->history_size()));
  if (parts_->substepper) parts_->substepper->initialise(state);
  return state;
}

void SoftBody::set_in_force(double stiffness, bool attached) {
  SoftMatter& m = parts_->matter;
  if (stiffness == m.strength && attached == m.tied) return;
  m.strength = stiffness;
  m.tied = attached;
  m.weigh();
  parts_->potential.reweigh();
  parts_->substepper = substepper_of(m);
  parts_->recovery.reweigh();
}

bool SoftBody::attached() const {
  return !parts_->matter.attached.isZero();
}
Weight SoftBody::weight(const Vec3& gravity, bool borne) const {
  const SoftMatter& m = parts_->matter;
  if (!m.falls()) return {};
  return borne && m.borne.size() > 0 ? Weight(gravity, m.borne) : Weight(gravity);
}

IncrementalPotential& SoftBody::potential() {
  return parts_->potential;
}
ImplicitStepper& SoftBody::stepper() {
  return parts_->stepper;
}
const ImplicitStepper& SoftBody::stepper() const {
  return parts_->stepper;
}
Substepper* SoftBody::substepper() const {
  return parts_->substepper.get();
}
MeshFollower& SoftBody::follower() {
  return parts_->follower;
}
const MeshFollower& SoftBody::follower() const {
  return parts_->follower;
}
RecoveryLaw& SoftBody::recovery() {
  return parts_->recovery;
}
const RecoveryLaw& SoftBody::recovery() const {
  return parts_->recovery;
}
SoftBody& SoftBody::in_force(const SoftBodyState& state) {
  return state.recovering ? parts_->recovery.body() : *this;
}

}  // namespace prosector::soft
