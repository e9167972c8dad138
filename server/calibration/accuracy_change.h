#pragma once
// Changes the accuracy of one body of a running scene: the errors and costs that it can have, and the choice
// for a requested error.

#include <optional>
#include <string>
#include <vector>

#include "common/error_estimate.h"
#include "server/calibration/choose_scene.h"

namespace prosector {

/// Removes the rung that the author fixed. The material stays, and so do a constitutive law and a mesh file
/// that the author named.
SoftDesc without_fixed_rung(SoftDesc desc);

class AccuracyChange {
 public:
  /// Prepares choices for a body of a scene that has its current choices adopted. Throws InputError when it
  /// has no soft body of that name.
  AccuracyChange(const SceneDesc& scene, const std::string& body, ChoiceOptions options);

  /// Returns the cheapest rung with an error of at most `percent`. Throws InputError for a body without
  /// tetrahedra.
  Choice choose(double percent) const;
  /// Returns the errors and costs that the body can have, the cheapest first, each more accurate than the one
  /// before: its Pareto front over the rungs tried.
  std::vector<Price> prices() const;

 private:
  SceneDesc scene_;  // with this body as the only soft one
  ChoiceOptions options_;
};

/// Returns prices as text: "30 % for 0.8 ms a frame, 7 % for 4.1".
std::string in_words(const std::vector<Price>& prices);

}  // namespace prosector
