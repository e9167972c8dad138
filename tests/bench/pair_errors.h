#pragma once
// What a session finds of pairs of bodies, against the reference.

#include <optional>
#include <vector>

#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "tests/bench/report.h"

namespace prosector {

/// The deepest, or nearest, contact of a pair.
struct PairContact {
  double gap = 0;               // m, < 0: depth
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
};

/// Keeps the deeper of the two.
void keep_deepest(std::optional<PairContact>& kept, const PairContact& found);

/// Counts pairs and gathers their errors. A pair hits where its gap is at most 0.
class PairErrors {
 public:
  /// `size`: m; depths are told as shares of it.
  explicit PairErrors(double size) : size_(size) {}

  /// `truth`: of the reference at fidelity `mesh`; nothing: the pair is apart.
  void add(const std::optional<PairContact>& found, const std::optional<Proximity>& truth);

  /// Adds `pairs`, `hits` (of the reference), `false_hits` (of the pairs that the reference leaves apart),
  /// `missed_hits` (of those that it doesn't), `depth_error` and `normal_error_deg` (medians over the hits of
  /// both).
  void tell(ReportRow& row) const;

 private:
  double size_;
  int pairs_ = 0, hits_ = 0, false_hits_ = 0, missed_ = 0;
  std::vector<double> depths_, normals_;
};

}  // namespace prosector
