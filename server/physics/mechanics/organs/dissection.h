#pragma once
// State of all cuts: cut organs, blades, and locally refined bodies.

#include <cstdint>
#include <map>
#include <vector>

#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/mechanics/organs/refined_body.h"

namespace prosector::organs {

struct Dissection {
  std::map<std::size_t, Organ> organs;  // cut organs, by index of the original soft body
  std::vector<Blade> blades;            // held by hands; by slot
  std::uint64_t strokes = 0;            // number of strokes of all blades so far
  RefinedBodies refined;                // all bodies that may be refined; cut bodies are not refined

  // ---- Created with the scene, not saved
  /// Organs (soft bodies prepared for cutting) that were not cut yet, by index of the soft body. Built in
  /// advance, so that the first cut is fast, and only in scenes with a blade.
  std::map<std::size_t, Organ> uncut;
  std::vector<VecX> uncut_equilibrium;  // 3n, m: of the scene's soft bodies as compiled

  bool ever_cut() const { return !organs.empty() || !blades.empty() || strokes > 0; }
};

}  // namespace prosector::organs
