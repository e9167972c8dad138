#pragma once
// Measurements of bench_collision, which use the collision detection of sessions. Each returns a report row.

#include "tests/bench/report.h"
#include "tests/collision/reference/collision_object.h"
#include "tests/collision/shapes.h"

namespace prosector {

/// Random pairs of a rigid shape with the shapes of the table, posed so that their enclosing spheres touch.
class RigidPairs {
 public:
  /// Creates the pairs and computes the reference result of each.
  RigidPairs(const test::NamedParts& shape, int pairs);
  /// Measures pairs in a rigid world with both bodies at `fidelity`: `us_per_pair` of RigidWorld::detect(),
  /// the errors of PairErrors, `bytes_per_object`.
  ReportRow measure(Fidelity fidelity) const;

 private:
  struct Placed {
    std::size_t other;
    Pose a, b;
    Quat start_a, start_b;  // initial rotations in the scene
    std::optional<collision::Proximity> truth;
  };
  std::string name_;
  std::vector<collision::ShapePart> parts_;
  double size_ = 0;  // m, diameter of the enclosing sphere
  std::vector<Placed> pairs_;
};

/// Measures a soft organ at `fidelity` with a rigid body at fidelity `mesh` in random poses around it:
/// `us_per_pair` of add_contacts(), and the errors of PairErrors.
ReportRow measure_organ_and_rigid(Fidelity fidelity, const test::NamedParts& shape, int pairs);

/// Measures two soft organs at `fidelity`, the second in random poses: `us_per_pair` of add_pair_contacts(),
/// and the errors of PairErrors.
ReportRow measure_two_organs(Fidelity fidelity, int pairs);

/// Measures a rigid world of moving bodies of all shapes, at the same density for any number: `ms_place`
/// (updating poses), `ms_detect`, `contacts`, `bytes_per_body`.
ReportRow measure_bodies(Fidelity fidelity, int bodies, int ticks);

/// Measures the surfaces of two solids, one of which bends a little more every tick. `levels`: subdivision
/// level. Figures: `ms_build`, `ms_refit`, `ms_apart` (contacts, nearly touching), `ms_crossing` (contacts,
/// overlap of 10 %), `ms_list` (building the self-collision list), `ms_self` (self-collision in later ticks),
/// `bytes_per_triangle`.
ReportRow measure_surface(int levels, int ticks);

/// Measures two sheets, one above the other, with `cells` cells per side: `ms_refit`, `ms_layers` (finding
/// all contacts), `meetings` (number of contacts).
ReportRow measure_layers(int cells, int ticks);

/// Measures a session of `bodies` small falling soft balls, 0.1 m apart: `ms_narrow` (detection time per
/// tick), `all_pairs` (number of pairs).
ReportRow measure_soft_session(int bodies, int ticks);

}  // namespace prosector
