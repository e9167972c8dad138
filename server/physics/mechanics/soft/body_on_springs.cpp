#include "server/physics/mechanics/soft/body_on_springs.h"

#include <algorithm>
#include <utility>

namespace prosector::soft {

BodyOnSprings::BodyOnSprings(IncrementalPotential& potential, Eigen::Index nodes)
    : potential_(potential), diagonal_(static_cast<std::size_t>(nodes)), inverse_(diagonal_.size()) {}

void BodyOnSprings::refresh(std::vector<Spring> springs) {
  springs_ = std::move(springs);
  potential_.diagonal(diagonal_);
  for (const Spring& spring : springs_)
    for (const auto& [node, weight] : spring.nodes)
      diagonal_[static_cast<std::size_t>(node)] += weight * weight * spring.stiffness;
  std::transform(diagonal_.begin(), diagonal_.end(), inverse_.begin(),
                 [](const Mat3& block) -> Mat3 { return block.inverse(); });
}

void BodyOnSprings::multiply(const VecX& p, VecX& Hp) const {
  potential_.multiply(p.data(), Hp.data());
  for (const Spring& spring : springs_) {
    Vec3 u = Vec3::Zero();
    for (const auto& [node, weight] : spring.nodes) u += weight * p.segment<3>(3 * node);
    const Vec3 force = spring.stiffness * u;
    for (const auto& [node, weight] : spring.nodes) Hp.segment<3>(3 * node) += weight * force;
  }
}

void BodyOnSprings::block_jacobi(const VecX& r, VecX& z) const {
  for (std::size_t i = 0; i < inverse_.size(); ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(i);
    z.segment<3>(at) = inverse_[i] * r.segment<3>(at);
  }
}

void BodyOnSprings::elastic_factor(const VecX& r, VecX& z) const {
  potential_.factor_solve(r.data(), z.data());
}

void BodyOnSprings::multigrid(const VecX& r, VecX& z) const {
  potential_.multigrid_solve(diagonal_, inverse_, r.data(), z.data());
}

}  // namespace prosector::soft
