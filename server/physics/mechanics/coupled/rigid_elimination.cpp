#include "server/physics/mechanics/coupled/rigid_elimination.h"

#include <algorithm>

#include "common/assert.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/coupled/lever.h"
#include "server/physics/mechanics/coupled/rigid_energy.h"

namespace prosector::coupled {
namespace {

constexpr std::size_t factors_at_once = 16;

}  // namespace

void RigidElimination::begin(const Island& island, const IslandLayout& layout, const IslandJoints& joints,
                             double h) {
  island_ = &island;
  layout_ = &layout;
  h_ = h;
  joined_ = false;
  pairs_.clear();
  for (const auto* list : {&joints.contacts(), &joints.ties()})
    for (const Joint& joint : *list)
      if (joint.a.rigid >= 0 && joint.b.rigid >= 0)
        pairs_.push_back(std::minmax({layout.rigid_member(joint.a), layout.rigid_member(joint.b)}));
  if (!pairs_.empty()) block_.begin(island.rigid.size(), pairs_);
  own_.resize(island.rigid.size());
  sums_.resize(island.rigid.size());
  factors_.resize(island.rigid.size());
}

void RigidElimination::assemble(const VecX& q) {
  PROSECTOR_ASSERT(q.size() == layout_->size);
  for (std::size_t m = 0; m < own_.size(); ++m)
    sums_[m] = own_[m] = hessian_of(island_->rigid[m], q.segment<6>(layout_->rigid(m)), h_);
}

void RigidElimination::add(const JointSide& side, const Mat3& D) {
  PROSECTOR_ASSERT(side.rigid >= layout_->rigid_begin);
  const Mat36 J = lever(side.arm);
  sums_[layout_->rigid_member(side)] += J.transpose() * D * J;
}

void RigidElimination::factor(const std::vector<const Joint*>& stiff, const JointProduct& product) {
  PROSECTOR_ASSERT(sums_.size() == island_->rigid.size());
  product_ = &product;
  condensed_ = layout_->rigid_begin > 0 && layout_->rigid_begin < layout_->size;
  for (std::size_t m = 0; m < sums_.size(); ++m) factors_[m].compute(sums_[m]);
  if (!pairs_.empty()) factor_joined(stiff);
}

void RigidElimination::factor_joined(const std::vector<const Joint*>& stiff) {
  block_.set_zero();
  for (std::size_t m = 0; m < sums_.size(); ++m) block_.add(m, sums_[m]);
  for (const Joint* joint : stiff) {
    if (joint->a.rigid < 0 || joint->b.rigid < 0) continue;
    const bool in_order = joint->a.rigid < joint->b.rigid;
    const JointSide &first = in_order ? joint->a : joint->b, &second = in_order ? joint->b : joint->a;
    block_.add(layout_->rigid_member(first), layout_->rigid_member(second),
               -lever(first.arm).transpose() * joint->D * lever(second.arm));
  }
  joined_ = block_.factor();
  condensed_ = condensed_ && joined_;
}

void RigidElimination::solve(const VecX& r, VecX& z) const {
  const auto size = layout_->size - layout_->rigid_begin;
  if (joined_) {
    block_.solve(r.tail(size), z.tail(size));
    return;
  }
  parallel_short_chunks(
      factors_.size(), factors_at_once, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t m = first; m < last; ++m)
          z.segment<6>(layout_->rigid(m)) = factors_[m].solve(r.segment<6>(layout_->rigid(m)));
      });
}

void RigidElimination::multiply(const VecX& p, VecX& Hp) const {
  PROSECTOR_ASSERT(p.size() == layout_->size && Hp.size() == layout_->size);
  for (std::size_t m = 0; m < own_.size(); ++m)
    Hp.segment<6>(layout_->rigid(m)) = own_[m] * p.segment<6>(layout_->rigid(m));
}

void RigidElimination::condense(VecX& g) const {
  PROSECTOR_ASSERT(g.size() == layout_->size);
  if (!condensed_) return;
  work_.resize(layout_->size);
  solve(g, work_);
  product_->subtract_from_nodes(work_, g);
  g.tail(layout_->size - layout_->rigid_begin).setZero();
}

void RigidElimination::expand(const VecX& g, const VecX& solved, VecX& step) const {
  PROSECTOR_ASSERT(g.size() == layout_->size && solved.size() == layout_->size);
  step = solved;
  if (!condensed_) return;
  rest_ = g;  // minus the forces on the rigid bodies due to the soft nodes' step
  product_->subtract_from_bodies(step, rest_);
  solve(rest_, step);
}

void RigidElimination::precondition(const VecX& r, VecX& z) const {
  PROSECTOR_ASSERT(r.size() == layout_->size && z.size() == layout_->size);
  if (condensed_)
    z.tail(layout_->size - layout_->rigid_begin).setZero();
  else
    solve(r, z);
}

}  // namespace prosector::coupled
