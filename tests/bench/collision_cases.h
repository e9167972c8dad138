#pragma once
// What bench_collision measures of the code that sessions run; each returns a row of its report.

#include "tests/bench/report.h"
#include "tests/collision/reference/collision_object.h"
#include "tests/collision/shapes.h"

namespace prosector {

/// Random poses of a shape beside others of the table, all rigid, within reach of the two's enclosing
/// spheres.
class RigidPairs {
 public:
  /// Finds what the reference has to say of each pair.
  RigidPairs(const test::NamedParts& shape, int pairs);
  /// Two bodies of the rigid world, both at that fidelity: `us_per_pair` of RigidWorld::detect(), errors as
  /// PairErrors has them, `bytes_per_object`. `scale`: all lengths are so many times as large, and gaps told
  /// as if they weren't: what changes with it is rounding and Bullet's fixed tolerances and margins.
  ReportRow measure(Fidelity fidelity, double scale = 1) const;

 private:
  struct Placed {
    std::size_t other;
    Pose a, b;
    Quat start_a, start_b;  // how they were turned when the scene began
    std::optional<Proximity> truth;
  };
  std::string name_;
  std::vector<ShapePart> parts_;
  double size_ = 0;  // m, diameter of the enclosing sphere
  std::vector<Placed> pairs_;
};

/// A soft organ at that fidelity in the middle, a rigid body of that shape at fidelity `mesh` in random poses
/// around it: `us_per_pair` of add_contacts(), errors as PairErrors has them.
ReportRow measure_organ_and_rigid(Fidelity fidelity, const test::NamedParts& shape, int pairs);

/// Two soft organs, both at that fidelity, the second in random poses: `us_per_pair` of add_pair_contacts(),
/// errors as PairErrors has them.
ReportRow measure_two_organs(Fidelity fidelity, int pairs);

/// A rigid world with bodies of all shapes, equally dense for any number, which all move a little each tick:
/// `ms_place`, `ms_detect`, `contacts`, `bytes_per_body`.
ReportRow measure_bodies(Fidelity fidelity, int bodies, int ticks);

/// Two solids' surfaces of about that many triangles, one bent a little more each tick: `ms_build`,
/// `ms_refit`, `ms_apart` (meetings, nearly touching), `ms_crossing` (a tenth deep), `ms_list` (what may meet
/// itself, found anew), `ms_self` (in later ticks), `bytes_per_triangle`.
ReportRow measure_surface(int levels, int ticks);

/// Two sheets of that many cells along a side, one above the other: `ms_refit`, `ms_layers`, `meetings`.
ReportRow measure_layers(int cells, int ticks);

/// A session of that many small soft balls, 0.1 m from one another, that all fall: `ms_narrow` of a
/// tick, beside the number of `all_pairs`.
ReportRow measure_soft_session(int bodies, int ticks);

}  // namespace prosector
