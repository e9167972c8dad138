#pragma once
// Finds any printed image in undistorted images of a camera, and follows it from image to image.
//
// Detection uses SIFT features (Lowe 2004), described at several scales, because a distant camera blurs fine
// detail. Matches that fit one homography are used (RANSAC, Fischler and Bolles 1981). Tracking uses optical
// flow (Lucas and Kanade 1981, in pyramids after Bouguet 2000). Flow starts not from the last image but from
// a rendering of the print at its last pose, so that errors don't accumulate.

#include <memory>
#include <optional>
#include <vector>

#include "drivers/camera/tags/board_pose.h"

namespace prosector {

class ImageTarget {
 public:
  /// Extracts the features of a board's printed image, by which it is recognised in camera images. Throws
  /// InputError if it has too few distinct features.
  explicit ImageTarget(const Board& board);
  ~ImageTarget();

  /// Searches the whole undistorted image for the printed image. Returns matched points with their pixels, or
  /// none if the print is not found.
  std::vector<DetectedCorner> find(const GreyImage& straight) const;
  /// Finds the printed image in an undistorted image near an expected pose, more exactly than find(). Returns
  /// matched points with their pixels, or none if the print is not found.
  std::vector<DetectedCorner> follow(const GreyImage& straight, const Lens& lens,
                                     const Pose& camera_board) const;

 private:
  struct Level;
  struct Features;
  struct Expected;
  std::optional<Expected> expect(const GreyImage& straight, const Lens& lens, const Pose& camera_board) const;

  std::vector<Level> levels_;  // the finest first
  std::unique_ptr<Features> features_;
};

}  // namespace prosector
