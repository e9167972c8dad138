#pragma once
// What bench_collision measures; each returns a row of its report.

#include "server/physics/collision/collision_world.h"
#include "tests/bench/report.h"
#include "tests/collision/shapes.h"

namespace prosector {

/// Random poses of a shape beside others of the table, both at that fidelity, against both as meshes.
class CollisionPairs {
 public:
  /// Every pair within reach of the two's enclosing spheres; the answers of mesh are found here.
  CollisionPairs(const test::NamedParts& shape, int pairs);
  /// `us_per_pair`; `false_hits` of the pairs that mesh leaves apart, `missed_hits` of those it doesn't;
  /// `depth_error` (median, of the shape's size) and `normal_error_deg` (median) of the hits of both;
  /// `bytes_per_object`, those of its shape included.
  ReportRow measure(Fidelity fidelity) const;

 private:
  struct Placed {
    std::size_t other;
    Pose a, b;
    std::optional<Proximity> truth;
  };
  std::string name_;
  std::vector<test::NamedParts> table_;
  std::vector<ShapePart> parts_;
  double size_ = 0;  // m, diameter of the enclosing sphere
  std::vector<Placed> pairs_;
};

/// A cloud of bodies of all shapes, equally dense for any number, which all move a little each tick:
/// `ms_place`, `ms_detect`, `touches`, `broad_pairs`, `bytes_per_body`.
ReportRow measure_bodies(Fidelity fidelity, int bodies, int ticks);

/// Two soft organs of about that many triangles, one bent a little more each tick: `ms_build`, `ms_refit`,
/// `ms_apart` (nearly touching), `ms_crossing` (a tenth deep), `ms_self`, `bytes_per_triangle`.
ReportRow measure_surface(int levels, int ticks);

/// A session of that many small soft balls, 0.1 m from one another, that all fall: `ms_narrow` of a
/// tick, beside the number of `all_pairs`.
ReportRow measure_soft_session(int bodies, int ticks);

}  // namespace prosector
