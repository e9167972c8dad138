#pragma once
// Follows one board from picture to picture.
//
// Where its tags are read, corners give a pose and edges make it exact. Where blur or a hand hides what tags
// say, the corners of the last picture are followed for a while. Their optical flow is found as by Lucas and
// Kanade 1981, in pyramids after Bouguet 2000.

#include <optional>

#include "drivers/camera/tags/edge_fit.h"

namespace prosector {

/// One picture, as all trackers share it.
struct TagPicture {
  GreyImage bent;             // the camera's own
  GreyImage straight;         // the same without distortion
  std::vector<SeenTag> tags;  // of the straight one
  std::int64_t time_ns = 0;
};

/// How pictures of a camera are read.
struct TagOptics {
  Lens bent, straight;
  double response = usual_response;
};

struct TrackedBoard {
  Pose camera_board;                   // OpenCV's camera frame
  double deviation = 0;                // m: expected of its place along the worst direction
  std::optional<MotionSpread> spread;  // where its edges were fitted, in the camera's frame
  bool followed = false;               // by flow: its tags couldn't be read
  int twice = 0;                       // tags that were seen twice and left out
};

class BoardTracker {
 public:
  explicit BoardTracker(Board board);

  const Board& board() const { return board_; }
  /// Returns where the board is in the next picture, or nothing.
  std::optional<TrackedBoard> update(const TagPicture& picture, const TagOptics& optics);
  /// Forgets where it was.
  void forget() { last_.reset(); }

  static constexpr double longest_followed = 0.5;  // s that a board is followed without reading a tag

 private:
  struct Last {
    Pose camera_board;
    std::int64_t read_ns = 0;  // of the last picture in which tags were read
    GreyImage straight;
    std::vector<int> codes;  // of tags that were seen
  };
  std::vector<SeenCorner> follow(const TagPicture& picture, const TagOptics& optics) const;
  /// A pose made exact by edges, where they are found.
  struct Fitted {
    Pose camera_board;
    double rms = 0;        // pixels
    double deviation = 0;  // m
    int samples = 0;       // of edges
    MotionSpread spread = MotionSpread::Zero();
  };
  Fitted fit(const BoardPose& pose, const TagPicture& picture, const TagOptics& optics,
             const std::vector<int>& codes) const;
  std::optional<Fitted> choose(const std::vector<BoardPose>& poses, const TagPicture& picture,
                               const TagOptics& optics, const std::vector<int>& codes);

  Board board_;
  std::optional<Last> last_;
  double doubt_ = 0;  // that of two poses which look alike the right one is taken
};

}  // namespace prosector
