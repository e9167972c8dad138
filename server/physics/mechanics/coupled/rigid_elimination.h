#pragma once
// The rigid bodies' equations of an island, and their elimination from the linear solve.
//
// Where soft and rigid bodies are coupled, the linear solver works on the Schur complement of the soft nodes'
// equations. A light body's balance then holds exactly, however loose the solver's tolerance is; its unknowns
// in the solver stay 0.

#include <Eigen/Cholesky>

#include <vector>

#include "server/physics/mechanics/coupled/island_joints.h"
#include "server/physics/mechanics/coupled/joint_product.h"
#include "server/physics/mechanics/coupled/rigid_block.h"

namespace prosector {

/// Rigid bodies' part of the Newton system, eliminated by Schur complement.
class RigidElimination {
 public:
  /// Sets the island's rigid members and their possible couplings for a tick of h s. All arguments must
  /// outlive their use here.
  void begin(const Island& island, const IslandLayout& layout, const IslandJoints& joints, double h);

  /// Computes the bodies' own Hessian at q: inertia and pulls.
  void assemble(const VecX& q);
  /// Adds a joint's stiffness D (N/m) on a side that is on a rigid body.
  void add(const JointSide& side, const Mat3& D);
  /// Factors the sum. `stiff`: the joints with a stiffness; `product`: the same joints, packed; used until
  /// the next call.
  void factor(const std::vector<const Joint*>& stiff, const JointProduct& product);

  /// Writes the bodies' own Hessian times p into the rigid part of Hp.
  void multiply(const VecX& p, VecX& Hp) const;
  /// Replaces the rigid part f of a vector by 0 and adds −A_sr·A_rr⁻¹·f to the soft part, if bodies are
  /// eliminated.
  void condense(VecX& g) const;
  /// Computes the full step for the right side g. `solved`: solution for the right side from condense().
  void expand(const VecX& g, const VecX& solved, VecX& step) const;
  /// Writes the rigid part of the preconditioned vector z for r.
  void precondition(const VecX& r, VecX& z) const;

 private:
  void factor_joined(const std::vector<const Joint*>& stiff);
  void solve(const VecX& r, VecX& z) const;

  const Island* island_ = nullptr;
  const IslandLayout* layout_ = nullptr;
  const JointProduct* product_ = nullptr;
  double h_ = 0;
  std::vector<Mat6> own_;   // by body: inertia and pull
  std::vector<Mat6> sums_;  // by body: with joints
  std::vector<Eigen::LLT<Mat6>> factors_;
  std::vector<RigidBlock::Pair> pairs_;  // rigid bodies that share a contact or tie
  RigidBlock block_;                     // equations of all bodies in one matrix, if there are pairs
  bool joined_ = false;                  // whether block_ is factored
  bool condensed_ = false;               // whether bodies are eliminated
  mutable VecX work_, rest_;
};

}  // namespace prosector
