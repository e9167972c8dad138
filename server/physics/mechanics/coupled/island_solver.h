#pragma once
// Projected Newton on an island's potential.

#include <map>

#include "server/physics/mechanics/coupled/energy_guard.h"
#include "server/physics/mechanics/coupled/island_system.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector::coupled {

/// Rigid body that no hand pulls, by its slot, and whether it rests on soft tissue, directly or through other
/// rigid bodies.
struct BorneBody {
  std::size_t slot;
  bool on_tissue;
};

/// Projected-Newton solver that advances an island (soft and rigid bodies connected by contacts and ties) by
/// minimising its incremental energy. Buffers are reused, so the next tick of the same island allocates
/// nothing; they do not affect results.
class IslandSolver {
 public:
  /// Advances the island by one tick of h seconds, by minimising its incremental energy. Updates the soft
  /// bodies' states, the rigid bodies' twists and the contact forces, and returns the solver's report.
  ///
  /// Each Newton step uses the linear solver and the settings of the first soft body, or conjugate gradients
  /// without soft bodies. The line search follows Armijo's rule, so a linear solve that stops early still
  /// gives a descent direction.
  ///
  /// Rigid bodies take the whole tick in every stage of a multi-stage integrator; the result of the last
  /// stage counts. Where several bodies are coupled, rigid or soft, all are stepped by implicit Euler. Other
  /// methods weight forces differently than a rigid body does, so momentum would be lost.
  ///
  /// A tick is repeated more carefully, with implicit Euler, if a soft body without contacts gained more
  /// energy than allowed or became non-finite. If it still gains energy, its motion is shortened
  /// (energy_guard.h). For solid bodies in contact or tied, the island's total energy is checked, and the
  /// tick is repeated in the same way. The momentum of islands that nothing holds in the room is exact even
  /// if solves stop early.
  IslandReport solve(Island& island, double h);

 private:
  struct Limits;
  /// Energy balance of an island over a tick, J: its energy at the start and at the end, and gravity's work.
  /// The energy is the sum of kinetic energy and of that in tissue, contacts, ties and pulls.
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
  std::map<std::string, std::unique_ptr<soft::LinearSolver>> solvers_;  // by name; created on first use
  VecX start_, q_, g_, step_, next_;                                    // vectors of the system's unknowns
  VecX right_, solved_;                                                 // condensed right side and solution
  std::vector<double> work_;       // J, work of joints on each soft member
  std::vector<BorneBody> bodies_;  // by slot
  double stored_ = 0;              // J: in tissue and joints at the tick's end
};

}  // namespace prosector::coupled
