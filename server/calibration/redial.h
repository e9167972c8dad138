#pragma once
// Another accuracy for one body of a scene that runs already: what it can have, and the choice for what is
// asked.

#include <optional>
#include <string>
#include <vector>

#include "server/calibration/choose_scene.h"

namespace prosector {

/// Frees a body of the rung that its author gave it. Its material stays, the law if its author named one, and
/// the mesh that it has in a file.
SoftDesc freed(SoftDesc desc);

class Redial {
 public:
  /// Takes the scene with the choices that it runs with, as adopted. Throws InputError when it has no soft
  /// body of that name, or one without tetrahedra.
  Redial(const SceneDesc& scene, const std::string& body, ChoiceOptions options);

  /// Returns the cheapest way that is off by at most `percent`.
  Choice choose(double percent) const;
  /// Returns what the body can have, the cheapest first, each better than the one before: its Pareto front,
  /// as far as ways were tried.
  std::vector<Price> prices() const;

 private:
  SceneDesc scene_;  // with this body alone among the soft ones
  ChoiceOptions options_;
};

/// Returns prices in words: "30 % for 0.8 ms a frame, 7 % for 4.1".
std::string in_words(const std::vector<Price>& prices);

}  // namespace prosector
