// What a body does, and is asked, where its own law leaves it inside out.

#include <cmath>

#include "server/physics/soft/rungs.h"
#include "server/physics/soft/soft_body_impl.h"

namespace prosector {
namespace {

const char* const recovery_model = "fem_corotational";  // no minimum but the rest shape was ever seen

}  // namespace

bool SoftBody::has_recovery() const {
  const SoftDesc& desc = impl_->desc;
  return (desc.model != recovery_model || desc.element == "tet10") &&
         mesh_kind(impl_->anatomy) == MeshKind::tets;
}

void SoftBody::keep_recovering() {
  impl_->keeps_recovering = true;
}

bool SoftBody::keeps_recovering() const {
  return impl_->keeps_recovering;
}

SoftBody* SoftBody::recovery() {
  if (!impl_->recovery && has_recovery()) {
    SoftDesc desc = impl_->desc;
    desc.model = recovery_model;
    desc.integrator = "implicit_euler";
    desc.solver = "cg";
    desc.element = "tet4";
    desc.fiber_stiffness = 0;
    for (RegionDesc& region : desc.regions) region.fiber_stiffness = -1;
    desc.relaxation.clear();
    impl_->recovery = std::make_unique<SoftBody>(desc, Anatomy{impl_->linear_tets(), {}, {}});
    impl_->recovery->set_in_force(impl_->strength, impl_->tied);
  }
  return impl_->recovery.get();
}

SoftBody& SoftBody::in_force(const SoftBodyState& state) {
  return state.recovering ? *recovery() : *this;
}

bool SoftBody::turned_by(double angle, const VecX& x) const {
  if (impl_->model->objective()) return false;
  return best_rotation(impl_->rest(), impl_->mass, x).trace() < 1 + 2 * std::cos(angle);
}

double SoftBody::inverted_share(const VecX& x, double least) const {
  return crushed_share(impl_->linear_tets(), x, least);
}

double SoftBody::volume_share(const VecX& x) const {
  return prosector::volume_share(impl_->linear_tets(), x);
}

const TetMesh& SoftBody::linear_tets() const {
  return impl_->linear_tets();
}

void SoftBody::unfold(SoftBodyState& state) const {
  prosector::unfold(impl_->rest(), impl_->mass, impl_->model->objective(), state);
  if (impl_->attached.isZero()) return;
  state.motion.x = impl_->rest();
  state.motion.v.setZero();
}

}  // namespace prosector
