#pragma once
// Makes a board's pose best by its tags' black edges, which say far more than their corners.
//
// Across an edge at predicted place and normal n, brightness I rises from dark d to bright b. The edge lies
// where the area says, whatever blurs it evenly:
//   x = h − ∫ (I − d)/(b − d) dt  over t = −h … h, pixels along n.
// The pose minimises Σ ρ(x_i), ρ as Huber has it, by Gauss and Newton's method; edges are looked for anew at
// each pose. Brightness must be proportional to light: where it isn't, all tags seem too large
// (linear_light()).

#include <optional>

#include "drivers/camera/camera.h"
#include "drivers/camera/grey_image.h"
#include "drivers/camera/small_motion.h"
#include "drivers/camera/tags/board.h"
#include "drivers/camera/tags/board_pose.h"

namespace prosector {

struct EdgeFit {
  Pose camera_board;
  double rms = 0;           // pixels that edges are off, where they count fully
  int samples = 0;          // places along edges that count
  MotionSpread covariance;  // of the pose, in the camera's frame
};

/// Fits in the lens' own picture, from a pose that is right to a few pixels. `tags`: codes that were seen,
/// whose edges are looked at. Returns nothing where too few edges are found.
std::optional<EdgeFit> fit_edges(const GreyImage& image, const Lens& lens, const Board& board,
                                 std::span<const int> codes, const Pose& camera_board,
                                 double response = usual_response);

}  // namespace prosector
