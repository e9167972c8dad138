#pragma once
// Refines a board's pose with the black edges of its tags, which are far more informative than their corners.
//
// Across an edge at its predicted position, along its normal n, brightness I rises from dark d to bright b.
// The edge's offset follows from the area under this profile, independent of any symmetric blur:
//   x = h − ∫ (I − d)/(b − d) dt  over t = −h … h, pixels along n.
// The pose minimises Σ ρ(x_i) with Huber's loss ρ, by Gauss and Newton's method. Edges are searched again at
// each pose. Brightness must be proportional to light; otherwise all tags appear too large (linear_light()).

#include <optional>

#include "drivers/camera/base/camera.h"
#include "drivers/camera/base/grey_image.h"
#include "drivers/camera/base/small_motion.h"
#include "drivers/camera/tags/board.h"
#include "drivers/camera/tags/board_pose.h"

namespace prosector {

struct EdgeFit {
  Pose camera_board;
  double rms = 0;               // pixels, residual of the edge samples with full weight
  int samples = 0;              // number of edge samples used
  MotionCovariance covariance;  // covariance of the pose, in the camera's frame
};

/// Refines a board's pose by the black edges of its tags in the original, distorted image. `camera_board` is
/// a start that is right within a few pixels. `codes` are the detected tags, whose edges are fitted.
/// `response` is the exponent from light to brightness. Returns nothing if too few edges are found.
std::optional<EdgeFit> fit_edges(const GreyImage& image, const Lens& lens, const Board& board,
                                 std::span<const int> codes, const Pose& camera_board,
                                 double response = default_response);

}  // namespace prosector
