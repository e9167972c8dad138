#include "server/physics/mechanics/soft/recovery_law.h"

#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector::soft {
namespace {

const char* const recovery_model = "fem_corotational";

}  // namespace

RecoveryLaw::RecoveryLaw(const SoftMatter& matter) : matter_(matter) {}
RecoveryLaw::~RecoveryLaw() = default;

bool RecoveryLaw::exists() const {
  const SoftDesc& desc = matter_.desc;
  return (desc.configuration.model != recovery_model || desc.configuration.is_quadratic()) &&
         mesh_kind(matter_.anatomy) == MeshKind::tets;
}

SoftBody& RecoveryLaw::body() {
  if (!body_) {
    SoftDesc desc = matter_.desc;
    desc.configuration.model = recovery_model;
    desc.configuration.integrator = "implicit_euler";
    desc.configuration.solver = "cg";
    desc.configuration.element = "tet4";
    desc.material.fiber_stiffness = 0;
    for (RegionDesc& region : desc.material.regions) region.fiber_stiffness = -1;
    desc.material.relaxation.clear();
    body_ = std::make_unique<SoftBody>(desc, Anatomy{matter_.linear_tets(), {}, {}});
    reweigh();
  }
  return *body_;
}

void RecoveryLaw::reweigh() {
  if (body_) body_->set_in_force(matter_.strength, matter_.tied);
}

void RecoveryLaw::fit() {
  body_.reset();
}

}  // namespace prosector::soft
