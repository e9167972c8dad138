#pragma once
// What the coupled solver minimises: one island of soft bodies, rigid bodies and what joins them.
//
//   E(x, ξ) = Σ_soft E_soft(x) + Σ_rigid ½(ξ − ξ̃)ᵀ(M/h²)(ξ − ξ̃) + Σ contacts + Σ ties + Σ pulls
//
// Unknowns: the soft nodes' positions x (3 each), then per rigid body the twist ξ of its displacement over
// the tick. That is the translation of its centre of mass (m) and the rotation vector about it (rad), both in
// the world frame.

#include <string>
#include <vector>

#include "server/physics/contact/contact.h"
#include "server/physics/soft/soft_body.h"

namespace prosector {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

struct SoftMember {
  std::size_t index = 0;  // as in ContactSide::body
  SoftBody* body = nullptr;
  SoftBodyState* state = nullptr;
  const VecX* equilibrium = nullptr;  // 3n, m: where the body rests by itself; null: as at rest shape
  Weight weight = {};                 // in this tick, see weigh()
  // Results besides the state:
  int substeps = 0;       // that it took by itself; 0: it was minimised
  bool refused = false;   // its own method has a limit and needs more substeps than are allowed, or did not
                          // hold in this tick: stepped by implicit Euler
  bool degraded = false;  // not stepped as its description says, for that reason or another
  bool guarded = false;   // gained energy, or did not descend: this tick was taken again (energy_guard.h)
  bool limited = false;   // nodes were too fast for any step (energy_guard.h)
  bool euler = false;     // by implicit Euler in this tick, whatever its integrator
  std::string note = {};  // for people: how it was stepped, if not plainly minimised
};

/// The virtual coupling of a hand: it pulls a rigid body to a displacement, with bounded force and moment.
/// Quadratic up to the bound, linear beyond it.
struct Pull {
  Vec3 translation = Vec3::Zero(), rotation = Vec3::Zero();  // m, rad: where the twist is pulled to
  double stiffness = 0, angular_stiffness = 0;               // N/m, N·m/rad
  double max_force = 0, max_moment = 0;                      // N, N·m
};

struct RigidMember {
  std::size_t slot = 0;           // as in ContactSide::body
  double mass = 0;                // kg
  Mat3 inertia = Mat3::Zero();    // kg·m², world frame
  Vec6 predicted = Vec6::Zero();  // ξ̃: h times the velocity without contacts
  Vec6 steady = Vec6::Zero();     // h times its velocity
  std::optional<Pull> pull;
  Vec6 twist = Vec6::Zero();  // result
};

struct Island {
  std::vector<SoftMember> soft;
  std::vector<RigidMember> rigid;
  std::vector<Contact> contacts;
  std::vector<Tie> ties;
  bool driven = false;  // something that is driven touches it: it doesn't sleep
};

/// Gives every soft member its weight under `gravity`, m/s²: borne where something ties, holds or meets it.
void weigh(Island& island, const Vec3& gravity);

struct IslandReport {
  int newton_iterations = 0;
  int solver_iterations = 0;
  double residual = 0;     // relative, of the last linear solve
  double last_step = 0;    // m: largest node or body displacement of the last Newton step
  bool converged = false;  // last step below 0.1 mm, of small bodies less, and its forces solved for
  bool descended = true;   // false: a search found no lower energy
  bool finite = true;      // false, or out of the room: nothing was taken into the soft states
};

}  // namespace prosector
