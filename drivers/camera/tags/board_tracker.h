#pragma once
// Tracks one board through successive images.
//
// When tags are read, their corners give a pose and their edges refine it. When blur or a hand makes tags
// unreadable, optical flow follows the last image's corners for a while. A printed image is followed from
// image to image and searched for only now and then.

#include <optional>

#include "drivers/camera/tags/edge_fit.h"
#include "drivers/camera/tags/image_target.h"

namespace prosector {

/// One camera image prepared for board trackers: distorted and undistorted grey images and the detected tags.
/// All trackers of a camera share it.
struct TagImage {
  GreyImage bent;                 // the camera's original, distorted image
  GreyImage straight;             // the undistorted image
  std::vector<DetectedTag> tags;  // tags of the undistorted image
  std::int64_t time_ns = 0;
};

/// Lenses of a camera's distorted and undistorted images, and its response, the exponent from light to
/// brightness.
struct TagOptics {
  Lens bent, straight;
  double response = default_response;
};

struct TrackedBoard {
  Pose camera_board;     // in OpenCV's camera frame
  double deviation = 0;  // m: expected position error along the worst direction
  std::optional<MotionCovariance>
      spread;  // covariance in the camera's frame; set if edges or points of a printed image were fitted
  bool followed = false;  // true: found by optical flow, because no tag was readable
  int twice = 0;          // number of tags that were detected twice and left out
};

class BoardTracker {
 public:
  /// Prepares the tracking of a board. Throws InputError if the board is a printed image with too few
  /// distinct features.
  explicit BoardTracker(Board board);

  const Board& board() const { return board_; }
  /// Tracks the board in the next image. Returns its pose in the camera's frame, or nothing if the board is
  /// not found.
  std::optional<TrackedBoard> update(const TagImage& picture, const TagOptics& optics);
  /// Forgets the board's last pose and image, so that optical flow does not continue from them.
  void forget() { last_.reset(); }

  static constexpr double max_flow_time = 0.5;    // s, longest time to follow a board without reading a tag
  static constexpr double search_interval = 0.2;  // s, least time between searches for a printed image

 private:
  struct Last {
    Pose camera_board;
    std::int64_t read_ns = 0;  // time of the last image in which tags were read
    GreyImage straight;
    std::vector<int> codes;  // tags that were detected, each once
  };
  /// Points and tags of the board found in one image, by tag detection or by optical flow.
  struct Seen {
    std::vector<DetectedCorner> corners;
    std::vector<int> codes;  // tags whose edges to fit, each once
    bool followed = false;
    int twice = 0;
  };
  std::vector<DetectedCorner> follow(const TagImage& picture, const TagOptics& optics) const;
  Seen look_for_tags(const TagImage& picture, const TagOptics& optics) const;
  Seen look_for_picture(const TagImage& picture, const TagOptics& optics);
  /// Pose of the board in an image with its errors, refined by the edges of tags or by points of a printed
  /// image if such were found.
  struct Fitted {
    Pose camera_board;
    double rms = 0;        // pixels
    double deviation = 0;  // m
    int samples = 0;       // number of edge samples, or of points on a printed image
    MotionCovariance spread = MotionCovariance::Zero();
  };
  Fitted fit(const BoardPose& pose, const TagImage& picture, const TagOptics& optics, const Seen& seen) const;
  std::optional<Fitted> choose(const TagImage& picture, const TagOptics& optics, const Seen& seen);

  Board board_;
  std::shared_ptr<const ImageTarget> target_;  // null: the board has tags
  std::optional<std::int64_t>
      searched_ns_;  // time of the last image in which a printed image was searched for
  std::optional<Last> last_;
  double log_likelihood_ratio_ = 0;  // log likelihood ratio of the rejected ambiguous pose to the chosen one
};

}  // namespace prosector
