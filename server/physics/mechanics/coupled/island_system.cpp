#include "server/physics/mechanics/coupled/island_system.h"

#include <algorithm>

#include "common/assert.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/coupled/rigid_energy.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"

namespace prosector::coupled {
namespace {

constexpr std::size_t nodes_per_chunk = 512;

/// Returns the part of q that belongs to soft member m.
auto soft_part(const Island& island, const IslandLayout& layout, std::size_t m, const VecX& q) {
  PROSECTOR_ASSERT(q.size() == layout.size && m < layout.soft.size());
  return q.segment(layout.soft[m], 3 * island.soft[m].body->nodes());
}

}  // namespace

void IslandSystem::begin(Island& island, double h) {
  PROSECTOR_ASSERT(h > 0);
  island_ = &island;
  h_ = h;
  layout_.begin(island);
  joints_.begin(island, layout_, h);
  rigid_.begin(island, layout_, joints_, h);
  node_blocks_.resize(static_cast<std::size_t>(layout_.rigid_begin / 3));
  node_inverse_.resize(node_blocks_.size());
}

void IslandSystem::initial_guess(VecX& q) const {
  q.resize(layout_.size);
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    island_->soft[m].body->stepper().initial_guess(
        h_, *island_->soft[m].state, q.segment(layout_.soft[m], 3 * island_->soft[m].body->nodes()));
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    q.segment<6>(layout_.rigid(m)) = island_->rigid[m].steady;
}

void IslandSystem::start(VecX& q) const {
  q.resize(layout_.size);
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    q.segment(layout_.soft[m], 3 * island_->soft[m].body->nodes()) = island_->soft[m].state->motion.x;
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    q.segment<6>(layout_.rigid(m)) = island_->rigid[m].predicted;
}

double IslandSystem::energy(const VecX& q) {
  energies_.resize(island_->soft.size());
  parallel_each(energies_.size(), [&](std::size_t m) {
    energies_[m] = island_->soft[m].body->potential().energy(soft_part(*island_, layout_, m, q));
  });
  soft_energy_ = 0;
  for (const double energy : energies_) soft_energy_ += energy;
  return soft_energy_ + energy_but_soft(q);
}

double IslandSystem::stored_in_tissue(const VecX& q) const {
  PROSECTOR_ASSERT(energies_.size() == island_->soft.size());
  double sum = soft_energy_;
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    sum -= island_->soft[m].body->potential().inertia_energy(soft_part(*island_, layout_, m, q));
  return sum;
}

double IslandSystem::stored_in_joints(const VecX& q) {
  double sum = energy_but_soft(q);
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    sum -= inertia_energy(island_->rigid[m], q.segment<6>(layout_.rigid(m)), h_);
  return sum;
}

double IslandSystem::energy_but_soft(const VecX& q) {
  PROSECTOR_ASSERT(island_ != nullptr && q.size() == layout_.size);
  double sum = 0;
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    add_energy(island_->rigid[m], q.segment<6>(layout_.rigid(m)), h_, sum);
  joints_.add_energy(q, sum);
  return sum;
}

void IslandSystem::linearise(const VecX& q) {
  parallel_each(island_->soft.size(), [&](std::size_t m) {
    island_->soft[m].body->potential().linearise(soft_part(*island_, layout_, m, q));
  });
}

void IslandSystem::gradient(const VecX& q, VecX& g) {
  g.resize(layout_.size);
  parallel_each(island_->soft.size(), [&](std::size_t m) {
    soft::SoftBody& body = *island_->soft[m].body;
    body.potential().gradient(soft_part(*island_, layout_, m, q),
                              g.segment(layout_.soft[m], 3 * body.nodes()));
  });
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    set_gradient(island_->rigid[m], q.segment<6>(layout_.rigid(m)), h_, g.segment<6>(layout_.rigid(m)));
  joints_.add_gradient(q, g);
}

bool IslandSystem::assemble(const VecX& q, bool exact) {
  const bool kept = assemble_soft(q, exact);
  rigid_.assemble(q);
  assemble_joints(q);
  parallel_short_chunks(node_blocks_.size(), nodes_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          for (std::size_t i = first; i < last; ++i)
                            node_inverse_[i] = node_blocks_[i].inverse();
                        });
  product_.set(layout_, stiff_);
  rigid_.factor(stiff_, product_);
  return kept;
}

bool IslandSystem::assemble_soft(const VecX& q, bool exact) {
  kept_.assign(island_->soft.size(), 0);
  parallel_each(kept_.size(), [&](std::size_t m) {
    soft::SoftBody& body = *island_->soft[m].body;
    const auto x = soft_part(*island_, layout_, m, q);
    if (exact)
      body.potential().assemble(x);
    else
      kept_[m] = body.potential().assemble_roughly(x);
    body.potential().diagonal(
        std::span(node_blocks_)
            .subspan(static_cast<std::size_t>(layout_.soft[m] / 3), static_cast<std::size_t>(body.nodes())));
  });
  return std::any_of(kept_.begin(), kept_.end(), [](char kept) { return kept != 0; });
}

void IslandSystem::assemble_joints(const VecX& q) {
  joints_.linearise(q);
  stiff_.clear();
  for (const auto* joints : {&joints_.contacts(), &joints_.ties()})
    for (const Joint& joint : *joints) {
      if (joint.D.isZero(0)) continue;
      stiff_.push_back(&joint);
      add_block(joint.a, joint.D);
      add_block(joint.b, joint.D);
    }
}

void IslandSystem::add_block(const JointSide& side, const Mat3& D) {
  for (std::size_t k = 0; k < side.nodes; ++k)
    node_blocks_[static_cast<std::size_t>(side.offset[k] / 3)] += side.weight[k] * side.weight[k] * D;
  if (side.rigid >= 0) rigid_.add(side, D);
}

void IslandSystem::multiply(const VecX& p, VecX& Hp) const {
  PROSECTOR_ASSERT(p.size() == layout_.size);
  Hp.resize(layout_.size);
  parallel_each(island_->soft.size(), [&](std::size_t m) {
    island_->soft[m].body->potential().multiply(p.data() + layout_.soft[m], Hp.data() + layout_.soft[m]);
  });
  rigid_.multiply(p, Hp);
  product_.multiply(p, Hp);
  rigid_.condense(Hp);
}

void IslandSystem::block_jacobi(const VecX& r, VecX& z) const {
  PROSECTOR_ASSERT(r.size() == layout_.size);
  z.resize(layout_.size);
  parallel_short_chunks(node_inverse_.size(), nodes_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          for (std::size_t i = first; i < last; ++i) {
                            const auto at = 3 * static_cast<Eigen::Index>(i);
                            z.segment<3>(at) = node_inverse_[i] * r.segment<3>(at);
                          }
                        });
  rigid_.precondition(r, z);
}

void IslandSystem::multigrid(const VecX& r, VecX& z) const {
  PROSECTOR_ASSERT(r.size() == layout_.size);
  z.resize(layout_.size);
  parallel_each(island_->soft.size(), [&](std::size_t m) {
    soft::SoftBody& body = *island_->soft[m].body;
    const auto first = static_cast<std::size_t>(layout_.soft[m] / 3),
               count = static_cast<std::size_t>(body.nodes());
    body.potential().multigrid_solve(std::span(node_blocks_).subspan(first, count),
                                     std::span(node_inverse_).subspan(first, count),
                                     r.data() + layout_.soft[m], z.data() + layout_.soft[m]);
  });
  rigid_.precondition(r, z);
}

void IslandSystem::elastic_factor(const VecX& r, VecX& z) const {
  PROSECTOR_ASSERT(r.size() == layout_.size);
  z.resize(layout_.size);
  parallel_each(island_->soft.size(), [&](std::size_t m) {
    island_->soft[m].body->potential().factor_solve(r.data() + layout_.soft[m], z.data() + layout_.soft[m]);
  });
  rigid_.precondition(r, z);
}

}  // namespace prosector::coupled
