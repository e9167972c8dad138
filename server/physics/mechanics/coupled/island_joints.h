#pragma once
// An island's contacts and ties: energy, forces, lagged friction, and the momentum that Newton steps exchange
// through them.

#include <vector>

#include "server/physics/mechanics/coupled/contact_reach.h"
#include "server/physics/mechanics/coupled/island_layout.h"

namespace prosector::coupled {

// m: slip over which friction builds up; sticking contacts yield by less.
inline constexpr double slip_threshold = 2e-5;

/// Energy, forces and stiffnesses of all contacts and ties of an island, as functions of its unknowns. Also
/// records which momentum the Newton steps exchange through contacts. Visits only the contacts that may act
/// at the given unknowns (ContactReach).
class IslandJoints {
 public:
  /// Sets up the contacts and ties of `island` for a tick of h s and resets the record of exchanged forces.
  /// Stores pointers to `island` and `layout`, which must outlive their use here.
  void begin(Island& island, const IslandLayout& layout, double h);

  /// Returns the contacts that may act at the unknowns visited so far in this tick, in their order in the
  /// island. The references are valid until a function visits other unknowns.
  const std::vector<Joint>& contacts() const { return contacts_; }
  const std::vector<Joint>& ties() const { return ties_; }

  /// Sets each contact's friction limit to its friction coefficient times its normal force at the unknowns q.
  /// The limits stay constant (lagged) until the next call.
  void lag_friction(const VecX& q);
  /// Adds the energies (J) of all contacts and ties at the unknowns q to `sum`. They are added one after the
  /// other, because the result depends, through rounding, on the order.
  void add_energy(const VecX& q, double& sum);
  /// Adds the gradient of the contacts' and ties' energy at the unknowns q to g: N, or N·m for rotations of
  /// rigid bodies.
  void add_gradient(const VecX& q, VecX& g);
  /// Computes and stores, for the next Newton step from the unknowns q, the contact forces and the 3×3
  /// stiffnesses of contacts and ties.
  void linearise(const VecX& q);

  /// Adds to `work`, for each soft body, the work (J) of contacts and ties for the displacement from the
  /// unknowns `start` to q. Uses the forces at q.
  void work(const VecX& start, const VecX& q, std::vector<double>& work);
  /// Records that the fraction `length` (0 to 1) of the Newton step `step` was taken. Updates the force that
  /// each contact has exchanged so far from the linearised force. The bodies' momenta result from these
  /// linearised forces and not from the contact forces at the step's end.
  void take(double length, const VecX& step);
  /// Records that the forces are balanced at the current point of linearisation, so no Newton step is needed
  /// to balance them. Sets the exchanged force of each contact to its force there.
  void take_balanced();
  /// Returns whether contacts have not yet adapted to the last Newton step, so that another is needed. `q`:
  /// the unknowns after that step. True if on some body the contact forces differ by more than a tolerance
  /// from those that the step predicted.
  bool unsettled(const VecX& q);
  /// Writes the results of a tick into the island's contacts and ties: their forces at the unknowns q, and
  /// the forces exchanged over the tick. `all_held`: every rigid body is pulled by a hand, so momentum need
  /// not be conserved. The exchanged forces are then scaled up to make up for the part of the Newton steps
  /// that was not taken.
  void write_joint_forces(const VecX& q, bool all_held);

 private:
  /// Sums over the contacts of one body, N: normal forces, friction limits, and the absolute errors of the
  /// normal and friction forces that the last Newton step predicted.
  struct Load {
    double normal = 0, normal_off = 0, friction = 0, friction_off = 0;
  };

  const contact::Contact& contact(std::size_t c) const { return island_->contacts[reach_.listed()[c]]; }
  Joint join(const contact::ContactSide& a, const contact::ContactSide& b) const;
  Joint join_contact(std::uint32_t contact) const;
  void cover(const VecX& q);
  Vec3 held_slip(std::size_t c) const;
  double normal_force(std::size_t c, const VecX& q) const;      // N
  double load_of_friction(std::size_t c, const VecX& q) const;  // N: normal load of its friction
  double contact_energy(std::size_t c, const Vec3& u) const;
  Vec3 contact_force(std::size_t c, const Vec3& u, Mat3* D) const;
  Vec3 tie_force(std::size_t t, const VecX& q) const;
  void find_forces(const VecX& q);
  void add_load(const JointSide& side, const Load& load);

  Island* island_ = nullptr;
  const IslandLayout* layout_ = nullptr;
  double h_ = 0;
  double untaken_ = 1;  // fraction of the force balance that no Newton step has applied yet
  VecX start_;          // m, of the soft nodes
  ContactReach reach_;
  std::vector<Joint> contacts_, ties_;  // the contacts are those of reach_
  std::vector<std::uint32_t> joined_;   // by contact: index in Island::contacts
  std::vector<double> lagged_;          // N, by contact: friction coefficient times normal force
  std::vector<Load> soft_loads_, rigid_loads_;
  std::vector<double> energies_;  // J, by contact, of the last add_energy()
  std::vector<Vec3> forces_;      // N, by contact, of the last find_forces()
  std::vector<Joint> fewer_;      // buffers of cover()
  std::vector<double> fewer_lagged_;
};

}  // namespace prosector::coupled
