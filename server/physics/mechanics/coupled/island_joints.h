#pragma once
// An island's contacts and ties: energy, forces, lagged friction, and the momentum that Newton steps exchange
// through them.

#include <vector>

#include "server/physics/mechanics/coupled/island_layout.h"

namespace prosector {

// m: slip over which friction builds up; sticking contacts yield by less.
inline constexpr double slip_threshold = 2e-5;

/// Evaluates all contacts and ties of an island.
class IslandJoints {
 public:
  /// Sets the island's contacts and ties for a tick of h s. Island and layout must outlive their use here.
  void begin(Island& island, const IslandLayout& layout, double h);

  const std::vector<Joint>& contacts() const { return contacts_; }
  const std::vector<Joint>& ties() const { return ties_; }

  /// Sets friction limits from the normal forces at q, until the next call.
  void lag_friction(const VecX& q);
  /// Adds the joints' energy at q to the sum, J, one by one: the order of additions is part of the result.
  void add_energy(const VecX& q, double& sum) const;
  /// Adds the gradient of the joints' energy at q, N.
  void add_gradient(const VecX& q, VecX& g) const;
  /// Computes the contacts' forces and all stiffnesses at q.
  void linearise(const VecX& q);

  /// Adds the work (J) of the joints on each soft member between `start` and q, with the forces at q.
  void work(const VecX& start, const VecX& q, std::vector<double>& work) const;
  /// Records that `length` of a Newton step was taken from the point of linearisation. The bodies' momenta
  /// then result from the linearised forces, not from the contact forces at the step's end.
  void take(double length, const VecX& step);
  /// Records that the forces at the point of linearisation are already balanced. The exchanged forces are
  /// then the contacts' forces there, even if little of the next step is taken.
  void take_balanced();
  /// Returns whether contacts have not yet adapted to the last step. At q, the step's end, their forces
  /// (friction as lagged) differ from the step's prediction by more than a share of the forces on some body.
  bool unsettled(const VecX& q);
  /// Sets the results of contacts and ties: forces at q, and exchanged forces. `all_held`: every rigid body
  /// of the island is pulled, so momentum need not be conserved. The exchanged forces are then scaled up for
  /// the part of the Newton steps that was not taken.
  void tell_joints(const VecX& q, bool all_held) const;

 private:
  /// Sums of contact forces on a body and of their prediction errors, N.
  struct Load {
    double normal = 0, normal_off = 0, friction = 0, friction_off = 0;
  };

  Joint join(const ContactSide& a, const ContactSide& b) const;
  Vec3 held_slip(std::size_t c) const;
  double normal_force(std::size_t c, const VecX& q) const;      // N
  double load_of_friction(std::size_t c, const VecX& q) const;  // N: normal load of its friction
  double contact_energy(std::size_t c, const Vec3& u) const;
  Vec3 contact_force(std::size_t c, const Vec3& u, Mat3* D) const;
  Vec3 tie_force(std::size_t t, const VecX& q) const;
  void find_forces(const VecX& q) const;
  void add_load(const JointSide& side, const Load& load);

  Island* island_ = nullptr;
  const IslandLayout* layout_ = nullptr;
  double h_ = 0;
  double untaken_ = 1;  // fraction of the force balance that no Newton step has applied yet
  std::vector<Joint> contacts_, ties_;
  std::vector<double> lagged_;  // N, by contact: friction coefficient times normal force
  std::vector<Load> soft_loads_, rigid_loads_;
  mutable std::vector<double> energies_;  // J, by contact, of the last add_energy()
  mutable std::vector<Vec3> forces_;      // N, by contact, of the last find_forces()
};

}  // namespace prosector
