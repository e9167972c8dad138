#pragma once
// Changes the accuracy of one body of a running scene: the errors and costs that it can have, and the choice
// for a requested error.

#include <optional>
#include <string>
#include <vector>

#include "common/error_estimate.h"
#include "server/calibration/choose_scene.h"

namespace prosector {

/// Returns the description without the configuration (model, element, solver and effort) that the scene's
/// author fixed, so that another one can be chosen. The material remains, and so do a constitutive law and a
/// mesh file that the author named.
SoftDesc without_fixed_rung(SoftDesc desc);

class AccuracyChange {
 public:
  /// Prepares the choice of another configuration for the body named `body`. The current choices for all
  /// bodies must already be adopted in `scene`. Throws InputError if the scene has no soft body of that name.
  AccuracyChange(const SceneDesc& scene, const std::string& body, ChoiceOptions options);

  /// Returns the cheapest rung (model configuration) with an error of at most `percent` %. Throws InputError
  /// for a body without tetrahedra.
  Choice choose(double percent) const;
  /// Returns the pairs of error and cost that are available for the body, the cheapest first, each more
  /// accurate than the one before. They are the Pareto front of the configurations tried.
  std::vector<Price> prices() const;

 private:
  SceneDesc scene_;  // with this body as the only soft one
  ChoiceOptions options_;
};

/// Returns the available errors and costs of a body as text, such as "30 % for 0.8 ms per frame, 7 % for 4.1
/// ms per frame".
std::string in_words(const std::vector<Price>& prices);

}  // namespace prosector
