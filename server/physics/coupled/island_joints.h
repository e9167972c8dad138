#pragma once
// An island's contacts and ties: their energy and forces, friction that lags, and what Newton steps exchange
// through them.

#include <vector>

#include "server/physics/coupled/island_layout.h"

namespace prosector {

inline constexpr double slip_threshold = 2e-5;  // m: over it friction builds up; what holds gives way by less

class IslandJoints {
 public:
  /// Takes the island's contacts and ties over a tick of h s. Island and layout must outlive what is asked.
  void begin(Island& island, const IslandLayout& layout, double h);

  const std::vector<Joint>& contacts() const { return contacts_; }
  const std::vector<Joint>& ties() const { return ties_; }

  /// Makes friction use normal forces at q until the next call.
  void lag_friction(const VecX& q);
  /// Adds their energy at q to the sum, J, one by one: the order of additions is part of the result.
  void add_energy(const VecX& q, double& sum) const;
  /// Adds their energy's gradient at q, N.
  void add_gradient(const VecX& q, VecX& g) const;
  /// Finds contacts' forces and all stiffnesses at q.
  void linearise(const VecX& q);

  /// Adds the work (J) that they did to each soft member between `start` and q with the forces that they have
  /// at q.
  void work(const VecX& start, const VecX& q, std::vector<double>& work) const;
  /// Tells that `length` of a Newton step was taken from where they were linearised. The bodies' momenta are
  /// then those that the linearised forces gave them, not those that the contacts would have at its end.
  void take(double length, const VecX& step);
  /// Tells that forces balance already where they were linearised. What is exchanged there are the contacts'
  /// forces, also when little or nothing of the next step is taken.
  void take_balanced();
  /// Returns whether contacts have yet to follow. At q, where the last step led, their forces (friction as
  /// lagged) are others than the step took them for, by more than a share of those on some body.
  bool unsettled(const VecX& q);
  /// Fills the results of contacts and ties: forces at q, and what was exchanged. `all_held`: every body of
  /// the island is held or pulled. No momentum has to add up then, and what the steps left untaken counts
  /// like the rest.
  void tell_joints(const VecX& q, bool all_held) const;

 private:
  /// Contact forces on a body: how large, and how far off, N.
  struct Load {
    double normal = 0, normal_off = 0, friction = 0, friction_off = 0;
  };

  Joint join(const ContactSide& a, const ContactSide& b) const;
  Vec3 held_slip(std::size_t c) const;
  double normal_force(std::size_t c, const VecX& q) const;      // N
  double load_of_friction(std::size_t c, const VecX& q) const;  // N: what it is under
  double contact_energy(std::size_t c, const Vec3& u) const;
  Vec3 contact_force(std::size_t c, const Vec3& u, Mat3* D) const;
  Vec3 tie_force(std::size_t t, const VecX& q) const;
  void find_forces(const VecX& q) const;
  void add_load(const JointSide& side, const Load& load);

  Island* island_ = nullptr;
  const IslandLayout* layout_ = nullptr;
  double h_ = 0;
  double untaken_ = 1;  // share of what balances the forces that no Newton step has brought yet
  std::vector<Joint> contacts_, ties_;
  std::vector<double> lagged_;  // N: friction times normal force, by contact
  std::vector<Load> soft_loads_, rigid_loads_;
  mutable std::vector<double> energies_;  // J, by contact, of the last add_energy()
  mutable std::vector<Vec3> forces_;      // N, by contact, of the last find_forces()
};

}  // namespace prosector
