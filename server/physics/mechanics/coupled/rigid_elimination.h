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

namespace prosector::coupled {

/// Rigid bodies' part of an island's Newton system. Where soft and rigid bodies are coupled, it is eliminated
/// by Schur complement, so that the linear solver only works on soft nodes.
class RigidElimination {
 public:
  /// Sets up the equations of the island's rigid bodies for a tick of h s, with the pairs of bodies that
  /// share a contact or tie in `joints`. Stores pointers to `island` and `layout`, which must outlive their
  /// use here.
  void begin(const Island& island, const IslandLayout& layout, const IslandJoints& joints, double h);

  /// Computes each rigid body's own 6×6 Hessian at the unknowns q, from its inertia and from the pull of a
  /// hand, without contacts and ties.
  void assemble(const VecX& q);
  /// Adds the stiffness D (N/m, 3×3) of a contact or tie, on a side on a rigid body, to that body's 6×6
  /// diagonal block.
  void add(const JointSide& side, const Mat3& D);
  /// Factors the rigid bodies' matrix, including contacts and ties. `stiff`: the contacts and ties with a
  /// nonzero stiffness. `product`: their packed stiffness matrix, which must stay valid until the next call.
  void factor(const std::vector<const Joint*>& stiff, const JointProduct& product);

  /// Writes the product of the rigid bodies' own Hessian (inertia and pulls, without contacts and ties) with
  /// p into the rigid bodies' part of Hp.
  void multiply(const VecX& p, VecX& Hp) const;
  /// Eliminates the rigid bodies from the right side g. Adds −A_sr·A_rr⁻¹·f to its soft part, where f is its
  /// rigid part, and sets the rigid part to 0. A_sr is the soft-rigid block and A_rr the rigid block of the
  /// Newton matrix. Does nothing if rigid bodies are not eliminated.
  void condense(VecX& g) const;
  /// Computes the full Newton step, for soft nodes and rigid bodies. `g`: the full right side; `solved`: the
  /// linear solver's solution for the right side from condense().
  void expand(const VecX& g, const VecX& solved, VecX& step) const;
  /// Writes the rigid bodies' part of the preconditioned residual z for the residual r. It is zero if the
  /// bodies are eliminated from the linear system. Otherwise it solves the rigid bodies' equations alone.
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

}  // namespace prosector::coupled
