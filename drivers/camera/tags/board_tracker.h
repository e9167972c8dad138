#pragma once
// Follows one board from picture to picture.
//
// Where its tags are read, corners give a pose and edges make it exact. Where blur or a hand hides what tags
// say, the corners of the last picture are followed by flow for a while. A printed picture is searched seldom
// and followed else.

#include <optional>

#include "drivers/camera/tags/edge_fit.h"
#include "drivers/camera/tags/picture_target.h"

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
  std::optional<MotionSpread> spread;  // where its edges or places were fitted, in the camera's frame
  bool followed = false;               // by flow: its tags couldn't be read
  int twice = 0;                       // tags that were seen twice and left out
};

class BoardTracker {
 public:
  /// Makes ready. Throws InputError where the board is a picture with too little to tell apart.
  explicit BoardTracker(Board board);

  const Board& board() const { return board_; }
  /// Returns where the board is in the next picture, or nothing.
  std::optional<TrackedBoard> update(const TagPicture& picture, const TagOptics& optics);
  /// Forgets where it was.
  void forget() { last_.reset(); }

  static constexpr double longest_followed = 0.5;  // s that a board is followed without reading a tag
  static constexpr double search_pause = 0.2;      // s between searches for a printed picture

 private:
  struct Last {
    Pose camera_board;
    std::int64_t read_ns = 0;  // of the last picture in which tags were read
    GreyImage straight;
    std::vector<int> codes;  // of tags that were seen
  };
  /// What a picture shows of the board.
  struct Seen {
    std::vector<SeenCorner> corners;
    std::vector<int> codes;  // of tags whose edges are looked at
    bool followed = false;
    int twice = 0;
  };
  std::vector<SeenCorner> follow(const TagPicture& picture, const TagOptics& optics) const;
  Seen look_for_tags(const TagPicture& picture, const TagOptics& optics) const;
  Seen look_for_picture(const TagPicture& picture, const TagOptics& optics);
  /// A pose made exact by edges, where they are found.
  struct Fitted {
    Pose camera_board;
    double rms = 0;        // pixels
    double deviation = 0;  // m
    int samples = 0;       // of edges
    MotionSpread spread = MotionSpread::Zero();
  };
  Fitted fit(const BoardPose& pose, const TagPicture& picture, const TagOptics& optics,
             const Seen& seen) const;
  std::optional<Fitted> choose(const TagPicture& picture, const TagOptics& optics, const Seen& seen);

  Board board_;
  std::shared_ptr<const PictureTarget> target_;  // null: the board has tags
  std::optional<std::int64_t> searched_ns_;      // of the last picture in which a printed one was searched
  std::optional<Last> last_;
  double doubt_ = 0;  // that of two poses which look alike the right one is taken
};

}  // namespace prosector
