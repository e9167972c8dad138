#pragma once
// Projected Newton on an island's potential.

#include <map>

#include "server/physics/coupled/energy_guard.h"
#include "server/physics/coupled/island_system.h"
#include "server/physics/soft/solvers/linear_solver.h"

namespace prosector {

/// A rigid body that nothing pulls, and whether tissue bears it, be it through others.
struct BorneBody {
  std::size_t slot;
  bool on_tissue;
};

/// Keeps what ticks work in, so that the same island's next tick allocates nothing; nothing of it is state.
class IslandSolver {
 public:
  /// Minimises the island's energy over one tick of h seconds, then finishes the soft bodies' stages and
  /// fills the rigid twists and the contacts' forces. Each Newton step solves with the first soft body's
  /// linear solver and settings (an island without one: conjugate gradients). It descends by Armijo's rule,
  /// so a solve that stops early is still a descent; what was left is in the report. Rigid bodies take the
  /// whole tick in every stage of a multi-stage integrator; the last stage's result counts. Where several
  /// bodies move together, rigid or soft, all are stepped by implicit Euler. Other methods weigh a force
  /// otherwise than a rigid body does, and momentum would be lost between them. A tick that is not finite, or
  /// after which a soft body has more energy than explained, is taken again with more care. It is then
  /// stepped by implicit Euler, and if need be shortened (energy_guard.h). Where solid bodies touch or hold
  /// others, the island's energy is watched, and the tick taken again with more care. Momentum of what
  /// nothing holds in the room is right however early a solve stops.
  IslandReport solve(Island& island, double h);

 private:
  struct Limits;
  /// J, of an island: in motion, tissue, contacts, ties and pulls.
  struct Account {
    double had = 0;    // when the tick began
    double given = 0;  // by weight
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
  std::map<std::string, std::unique_ptr<LinearSolver>> solvers_;  // by name; made when first asked for
  VecX start_, q_, g_, step_, next_;                              // as the system's unknowns
  VecX right_, solved_;                                           // condensed
  std::vector<double> work_;                                      // J, by joints, on each soft member
  std::vector<BorneBody> bodies_;                                 // by slot
  double stored_ = 0;  // J: in tissue and joints when the tick ends
};

}  // namespace prosector
