#pragma once
// A camera's lens from views of a flat board (Zhang 2000; Brown's distortion, its sixth-order term left at
// 0).
//
// Corners come from each tag's four edges, in the camera's own picture, and are found anew with the lens so
// far. How brightness grows with light is found, too. Taken wrongly it makes all tags seem too large against
// their distances, so the exponent is that which leaves the least error.
//
// Tags may be too small or too blurred for that, as in images of 320 × 240. Then the tag finder's corners are
// fitted as they are, with the usual response.

#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "drivers/camera/camera_calibration.h"
#include "drivers/camera/tags/board.h"
#include "drivers/camera/tags/tag_finder.h"

namespace prosector {

/// One picture of the board.
struct LensView {
  GreyImage picture;
  std::vector<SeenTag> tags;  // found in the picture itself, not straightened
};

inline constexpr std::size_t least_views = 6;
inline constexpr std::size_t usual_views = 14;

struct LensFit {
  CameraCalibration calibration;
  double rms = 0;        // pixels, of the fitted views: says little
  double held_out = 0;   // pixels RMS, of views that the fit doesn't know: every fifth
  double covered = 0;    // share of the picture's cells in which corners lie
  bool by_edges = true;  // false: by rough corners, several times less exact
};

/// Fits. Throws InputError that says what to do where views are too few, too small, or all alike, and soon
/// after `stop` was requested.
LensFit fit_lens(const Board& board, std::span<const LensView> views, const std::string& camera,
                 const std::stop_token& stop = {});

/// What to tell who calibrates where a lens was fitted by rough corners.
inline constexpr const char* rough_lens_words =
    "The tags' edges are too small or too blurred in these images: the lens was fitted by their corners, "
    "several "
    "times less exactly. For a better one hold the board nearer, in more light, or set the camera to more "
    "pixels.";

/// A cell of a picture: its column and its row from the upper left.
using PictureCell = std::pair<int, int>;
inline constexpr int cells_across = 8, cells_down = 6;

/// Returns the cells of a picture in which a corner lies.
std::set<PictureCell> covered_cells(std::span<const LensView> views);
/// Returns their share of all cells.
double covered_share(std::span<const LensView> views);

}  // namespace prosector
