#pragma once
// Finds any printed picture in straight pictures of a camera, and follows it from one to the next.
//
// It is found by features (SIFT, Lowe 2004), which are described at several scales, since a camera far away
// blurs what is fine. Those that fit one plane count (RANSAC, Fischler and Bolles 1981).
// It is followed by optical flow (Lucas and Kanade 1981, in pyramids after Bouguet 2000). Flow leads not from
// the last picture, but from what should be seen where the print was, so that errors don't add up.

#include <memory>
#include <optional>
#include <vector>

#include "drivers/camera/tags/board_pose.h"

namespace prosector {

class PictureTarget {
 public:
  /// Makes it of a board's picture. Throws InputError where too little of it can be told apart.
  explicit PictureTarget(const Board& board);
  ~PictureTarget();

  /// Finds the print anywhere. Returns nothing where it isn't seen.
  std::vector<SeenCorner> find(const GreyImage& straight) const;
  /// Finds the print near a pose, more exactly. Returns nothing where it isn't there.
  std::vector<SeenCorner> follow(const GreyImage& straight, const Lens& lens, const Pose& camera_board) const;

 private:
  struct Level;
  struct Features;
  struct Expected;
  std::optional<Expected> expect(const GreyImage& straight, const Lens& lens, const Pose& camera_board) const;

  std::vector<Level> levels_;  // the finest first
  std::unique_ptr<Features> features_;
};

}  // namespace prosector
