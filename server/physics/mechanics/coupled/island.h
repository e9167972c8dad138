#pragma once
// One island of soft bodies, rigid bodies and their joints, and the energy that the coupled solver minimises.
//
//   E(x, ξ) = Σ_soft E_soft(x) + Σ_rigid ½(ξ − ξ̃)ᵀ(M/h²)(ξ − ξ̃) + Σ contacts + Σ ties + Σ pulls
//
// Unknowns: the soft nodes' positions x (3 each), then per rigid body the twist ξ of its displacement over
// the tick. That is the translation of its centre of mass (m) and the rotation vector about it (rad), both in
// the world frame.

#include <string>
#include <vector>

#include "server/physics/mechanics/contact/contact.h"
#include "server/physics/mechanics/hands/pull.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector::coupled {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

struct SoftMember {
  std::size_t index = 0;  // as in ContactSide::body
  soft::SoftBody* body = nullptr;
  soft::SoftBodyState* state = nullptr;
  // 3n, m: node positions at rest under gravity; null: the rest shape.
  const VecX* equilibrium = nullptr;
  soft::Weight weight = {};  // gravity in this tick, see weigh()
  // Results besides the state:
  int substeps = 0;  // number of substeps; 0: the body was minimised
  // The body's own method needs more substeps than allowed, or diverged in this tick: the body was stepped by
  // implicit Euler.
  bool refused = false;
  bool degraded = false;  // not stepped as described in the scene, for this or another reason
  bool guarded = false;   // gained energy, or found no descent: the tick was repeated (energy_guard.h)
  bool limited = false;   // node velocities were limited (energy_guard.h)
  bool euler = false;     // stepped by implicit Euler in this tick, whatever its integrator
  std::string note = {};  // user-readable: how the body was stepped, if not by plain minimisation
};

struct RigidMember {
  std::size_t slot = 0;           // as in ContactSide::body
  double mass = 0;                // kg
  Mat3 inertia = Mat3::Zero();    // kg·m², world frame
  Vec6 predicted = Vec6::Zero();  // ξ̃: h times the velocity that it would have without contacts
  Vec6 steady = Vec6::Zero();     // h times its velocity at the tick's start
  std::optional<hands::Pull> pull;
  Vec6 twist = Vec6::Zero();  // result
};

struct Island {
  std::vector<SoftMember> soft;
  std::vector<RigidMember> rigid;
  std::vector<contact::Contact> contacts;
  std::vector<contact::Tie> ties;
  bool driven = false;  // a kinematic body touches it, so it does not sleep
};

/// Sets in each soft body of the island the weight that acts in this tick under `gravity`, m/s². For bodies
/// with attachments, contacts or ties, quadratic elements distribute it to nodes by shape functions,
/// otherwise by nodal masses.
void weigh(Island& island, const Vec3& gravity);

struct IslandReport {
  int newton_iterations = 0;
  int solver_iterations = 0;
  double residual = 0;   // relative, of the last linear solve
  double last_step = 0;  // m: largest node or body displacement in the last Newton step
  // Last step below 0.1 mm (less for small bodies), with its linear system solved accurately enough.
  bool converged = false;
  bool descended = true;  // false: a line search found no lower energy
  // False: the result is not finite or outside the room, and the soft states are unchanged.
  bool finite = true;
};

}  // namespace prosector::coupled
