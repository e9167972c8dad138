#pragma once
// Fits a camera's lens to views of a flat board (Zhang 2000) with Brown's distortion; k3 stays 0.
//
// A tag's corners are projected from a pose that is fitted to its four edges in the original, distorted
// image. They are recomputed with each improved lens. The response, the exponent from light to brightness, is
// fitted too. A wrong response makes all tags appear too large for their distance, so the fit takes the
// response with the least error.
//
// Tags may be too small or too blurred for edge fits, as in images of 320 × 240. The fit then uses the tag
// detector's corners unchanged, with the usual response.

#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "drivers/camera/base/camera_calibration.h"
#include "drivers/camera/tags/board.h"
#include "drivers/camera/tags/tag_detector.h"

namespace prosector {

/// One image of the calibration board, and the tags detected in it.
struct LensView {
  GreyImage picture;
  std::vector<DetectedTag> tags;  // detected in the original, distorted image
};

inline constexpr std::size_t min_views = 6;
inline constexpr std::size_t recommended_views = 14;

struct LensFit {
  CameraCalibration calibration;
  double rms = 0;        // pixels RMS, over the fitted views; no measure of accuracy
  double held_out = 0;   // pixels RMS, over every fifth view, with a lens fitted to the other views
  double covered = 0;    // share of the image's cells that contain a corner, 0 to 1
  bool by_edges = true;  // false: fitted to the tag detector's corners, several times less exact
};

/// Fits a camera's lens to views of a board. `camera` is the camera's identity, to be stored in the
/// calibration. Throws InputError with advice if the views are too few, too small or all alike. Throws
/// InputError soon after `stop` is requested.
LensFit fit_lens(const Board& board, std::span<const LensView> views, const std::string& camera,
                 const std::stop_token& stop = {});

/// Message to the user for the case that the lens was fitted to the tag detector's corners, because the more
/// exact tag edges could not be used.
inline constexpr const char* coarse_lens_warning =
    "The tags' edges are too small or too blurred in these images: the lens was fitted to their corners, "
    "which is several times less accurate. For a better result hold the board nearer, add light, or increase "
    "the camera's resolution.";

/// Column and row, counted from the upper left, of a cell in the grid of 8 × 6 cells that divides an image.
using ImageCell = std::pair<int, int>;
inline constexpr int cells_across = 8, cells_down = 6;

/// Returns the cells of the image's 8 × 6 grid that contain a tag corner in at least one view.
std::set<ImageCell> covered_cells(std::span<const LensView> views);
/// Returns the fraction (0 to 1) of the cells of the image's 8 × 6 grid that contain a tag corner in at least
/// one view.
double covered_share(std::span<const LensView> views);

}  // namespace prosector
