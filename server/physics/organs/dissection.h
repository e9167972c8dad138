#pragma once
// What has been cut so far, the blades that cut, and what has smaller elements for now.

#include <cstdint>
#include <map>
#include <vector>

#include "server/physics/organs/blade.h"
#include "server/physics/organs/organ.h"
#include "server/physics/organs/refined_body.h"

namespace prosector {

struct Dissection {
  std::map<std::size_t, Organ> organs;  // those that were cut, by the soft body that each was
  std::vector<Blade> blades;            // that hands hold, by slot
  std::uint64_t strokes = 0;            // of all blades so far
  RefinedBodies refined;                // all that may be; what is cut isn't

  // ---- Made with the scene, not saved
  /// What a first cut asks of its organ's mesh, until one is made, by soft body: of scenes with a blade.
  std::map<std::size_t, Organ> uncut;
  std::vector<VecX> uncut_equilibrium;  // 3n, m: of the scene's soft bodies as they were compiled

  bool ever_cut() const { return !organs.empty() || !blades.empty() || strokes > 0; }
};

}  // namespace prosector
