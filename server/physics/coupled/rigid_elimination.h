#pragma once
// The rigid bodies' equations of an island, and their elimination from the linear solve.
//
// Where soft and rigid bodies meet, the linear solver sees the soft nodes' equations with the rigid bodies'
// eliminated (Schur's complement). A light body's balance is then met however loosely the tissue's is, and
// its rigid unknowns stay 0.

#include <Eigen/Cholesky>

#include <vector>

#include "server/physics/coupled/island_joints.h"
#include "server/physics/coupled/joint_product.h"
#include "server/physics/coupled/rigid_block.h"

namespace prosector {

class RigidElimination {
 public:
  /// Takes the island's rigid members over a tick of h s, and who of them may be joined. All must outlive
  /// what is asked of it.
  void begin(const Island& island, const IslandLayout& layout, const IslandJoints& joints, double h);

  /// Fixes the bodies' own Hessian at q: inertia and pulls.
  void assemble(const VecX& q);
  /// Adds a joint's stiffness D (N/m) on a side that is on a rigid body.
  void add(const JointSide& side, const Mat3& D);
  /// Factors the sum. `stiff`: the joints that have a stiffness; `product`: the same, until the next call.
  void factor(const std::vector<const Joint*>& stiff, const JointProduct& product);

  /// Writes the bodies' own Hessian times p into their part of Hp.
  void multiply(const VecX& p, VecX& Hp) const;
  /// Takes the rigid part f of a vector, the forces on the rigid bodies, to −A_sr·A_rr⁻¹·f on the soft nodes,
  /// where they are eliminated.
  void condense(VecX& g) const;
  /// Returns the whole step for the right side g. `solved`: the solution for what condense() made of g.
  void expand(const VecX& g, const VecX& solved, VecX& step) const;
  /// Writes the rigid part of a preconditioner's z for r.
  void precondition(const VecX& r, VecX& z) const;

 private:
  void factor_joined(const std::vector<const Joint*>& stiff);
  void solve(const VecX& r, VecX& z) const;

  const Island* island_ = nullptr;
  const IslandLayout* layout_ = nullptr;
  const JointProduct* product_ = nullptr;
  double h_ = 0;
  std::vector<Mat6> own_;   // by body: inertia and pull
  std::vector<Mat6> sums_;  // with joints
  std::vector<Eigen::LLT<Mat6>> factors_;
  std::vector<RigidBlock::Pair> pairs_;  // rigid bodies that touch or hold each other …
  RigidBlock block_;                     // … and then all equations as one
  bool joined_ = false;                  // block_ is factored
  bool condensed_ = false;               // bodies are eliminated
  mutable VecX work_, rest_;
};

}  // namespace prosector
