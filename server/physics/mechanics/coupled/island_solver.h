#pragma once
// Projected Newton on an island's potential.

#include <map>

#include "server/physics/mechanics/coupled/energy_guard.h"
#include "server/physics/mechanics/coupled/island_system.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {

/// A rigid body without a pull, and whether it rests on tissue, directly or through other bodies.
struct BorneBody {
  std::size_t slot;
  bool on_tissue;
};

/// Minimises an island's energy. Buffers are reused, so the next tick of the same island allocates nothing;
/// they are not state.
class IslandSolver {
 public:
  /// Minimises the island's energy over one tick of h seconds. Then finishes the soft bodies' stages and sets
  /// the rigid twists and the contact forces.
  ///
  /// Each Newton step uses the first soft body's linear solver and settings (an island without soft bodies:
  /// conjugate gradients). The line search follows Armijo's rule, so a linear solve that stops early still
  /// gives a descent direction. The report has its residual.
  ///
  /// Rigid bodies take the whole tick in every stage of a multi-stage integrator; the result of the last
  /// stage counts. Where several bodies are coupled, rigid or soft, all are stepped by implicit Euler. Other
  /// methods weight forces differently than a rigid body does, so momentum would be lost.
  ///
  /// A tick is repeated more carefully if it is not finite, or if a soft body has more energy than its bound.
  /// The repetition uses implicit Euler and is shortened if necessary (energy_guard.h). Where solid bodies
  /// are in contact or tied, the island's energy is checked, and the tick is repeated in the same way.
  /// Momentum of islands that nothing holds in the room is exact even if solves stop early.
  IslandReport solve(Island& island, double h);

 private:
  struct Limits;
  /// Energy balance of an island, J: kinetic, in tissue, contacts, ties and pulls.
  struct Account {
    double had = 0;    // at the tick's start
    double given = 0;  // work of gravity
    double has = 0;
  };

  Limits limits_of(const Island& island);
  void keep_momentum(const Island& island, double h);
  IslandReport attempt(Island& island, const Limits& limits, double h);
  IslandReport minimise(const Limits& limits, double tolerance);
  double line_search(double energy, double slope, int halvings);
  void start_where_energy_is_least();
  Account account(const Island& island, double h);
  bool gained_in_company(const Island& island, double h);

  IslandSystem system_;
  EnergyGuard guard_;
  std::map<std::string, std::unique_ptr<LinearSolver>> solvers_;  // by name; created on first use
  VecX start_, q_, g_, step_, next_;                              // vectors of the system's unknowns
  VecX right_, solved_;                                           // condensed right side and solution
  std::vector<double> work_;                                      // J, work of joints on each soft member
  std::vector<BorneBody> bodies_;                                 // by slot
  double stored_ = 0;                                             // J: in tissue and joints at the tick's end
};

}  // namespace prosector
