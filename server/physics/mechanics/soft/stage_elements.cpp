#include "server/physics/mechanics/soft/stage_elements.h"
#include "server/physics/mechanics/soft/base/scratch.h"

#include "common/ids.h"
#include "common/math.h"

namespace prosector::soft {
namespace {

/// Displacement of nodes, in cells, up to which a matrix is still a good approximation.
constexpr double same_tangent = 0.1;

}  // namespace

StageElements::StageElements(const SoftSystem& system, bool in_double) : system_(system) {
  if (system.model.turns()) rotated_.emplace(system.model.connectivity(), system.pattern, system.symmetric);
  if (in_double && system.damped()) fit_scratch(blocks_, system.pattern.blocks());
  fit();
}

void StageElements::fit() {
  if (rotated_) rotated_->fit();
  for (Linearised* place : {&first_, &later_}) {
    place->at.setZero(system_.model.rest().size());
    place->known = false;
  }
  present_ = assembled_ = nullptr;
  blocks_known_ = false;
}

void StageElements::begin_stage(const VecX& start, double scale, bool single) {
  start_ = &start;
  scale_ = scale;
  single_ = single;
  first_.known = false;
  if (system_.model.objective()) blocks_known_ = false;  // laws of small rotations have constant blocks
  present_ = assembled_ = nullptr;
}

/// Returns x, or the step's start if x is not finite or too large.
Eigen::Ref<const VecX> StageElements::somewhere(const Eigen::Ref<const VecX>& x) const {
  const bool good = x.allFinite() && x.lpNorm<Eigen::Infinity>() < max_coordinate;
  return good ? x : Eigen::Ref<const VecX>(*start_);
}

void StageElements::find(const Eigen::Ref<const VecX>& x, Linearised& out) {
  system_.model.linearise(x.data(), 1 / scale_, out.elements);
  out.at = x;
  out.known = true;
}

void StageElements::linearise(const Eigen::Ref<const VecX>& x) {
  if (present_ && x == present_->at) return;
  if (!first_.known) find(somewhere(x), first_);
  present_ = &first_;
  if (x == first_.at) return;
  find(x, later_);
  present_ = &later_;
  if (assembled_ == &later_) assembled_ = nullptr;
}

void StageElements::assemble(const Eigen::Ref<const VecX>& x, SymmetricRows& rows) {
  linearise(x);
  rotated_->assemble(present_->elements, rows);
  assembled_ = present_;
}

bool StageElements::near(const Eigen::Ref<const VecX>& x, const VecX& there) const {
  return (x - there).lpNorm<Eigen::Infinity>() <= same_tangent * system_.desc.geometry.cell;
}
bool StageElements::near_assembled(const Eigen::Ref<const VecX>& x) const {
  return assembled_ && near(x, assembled_->at);
}
bool StageElements::near_start(const Eigen::Ref<const VecX>& x) const {
  return near(x, *start_);
}

double StageElements::damping_energy(const Eigen::Ref<const VecX>& x, const VecX& u) {
  if (!first_.known) linearise(x);
  return rotated_->energy(first_.elements, u.data());
}

double StageElements::damping_forces(const Eigen::Ref<const VecX>& x, const VecX& u, VecX& f) {
  if (!first_.known) linearise(x);
  return rotated_->multiply(first_.elements, u.data(), f.data());
}

std::span<const Mat3> StageElements::damping_blocks(const Eigen::Ref<const VecX>& x) {
  if (!blocks_known_) {
    fit_scratch(blocks_, system_.pattern.blocks());
    system_.pattern.gather(system_.model.warped_stiffness(somewhere(x).data()), 0, {}, blocks_);
    blocks_known_ = true;
  }
  return blocks_;
}

}  // namespace prosector::soft
