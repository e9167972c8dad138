#pragma once
// Errors of a session's collision detection on pairs of bodies, against the reference.

#include <optional>
#include <vector>

#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "tests/bench/report.h"

namespace prosector {

/// The deepest contact of a pair, or the nearest if the bodies are separated.
struct PairContact {
  double gap = 0;               // m; negative: penetration
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
};

/// Replaces `kept` by `found` if that is deeper.
void keep_deepest(std::optional<PairContact>& kept, const PairContact& found);

/// Counts pairs and collects their errors. A pair is a hit if its gap is at most 0.
class PairErrors {
 public:
  /// `size`: object diameter, m; depth errors are reported relative to it.
  explicit PairErrors(double size) : size_(size) {}

  /// Adds a pair. `found`: the tested method's contact. `truth`: the reference at fidelity `mesh`. Empty: the
  /// pair is separated.
  void add(const std::optional<PairContact>& found, const std::optional<collision::Proximity>& truth);

  /// Writes to the row: `pairs`, `hits` (of the reference), `false_hits` (fraction of the pairs that the
  /// reference finds separated), `missed_hits` (fraction of its hits), `depth_error` and `normal_error_deg`
  /// (medians over pairs that both report as hits).
  void tell(ReportRow& row) const;

 private:
  double size_;
  int pairs_ = 0, hits_ = 0, false_hits_ = 0, missed_ = 0;
  std::vector<double> depths_, normals_;
};

}  // namespace prosector
