#pragma once
// Guides a user through the views of a lens calibration: takes one image after another and returns the next
// instruction.

#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/base/frame.h"
#include "drivers/camera/calibration/lens_fit.h"

namespace prosector {

struct LensGuideStep {
  std::string instruction;        // for the user, what to do now
  std::size_t views = 0;          // number of views stored
  double covered = 0;             // share of the image's cells that contain a corner, 0 to 1
  std::vector<DetectedTag> seen;  // tags in the last image, for display
  bool done = false;
};

class LensGuide {
 public:
  /// Starts a guided lens calibration with a printed board. Throws InputError if the board has no tags.
  explicit LensGuide(Board board);

  /// Processes an image of the camera. Stores it as a view for the lens fit if the board is at rest in it,
  /// large enough, and looks different from every stored view.
  void take(const Image& picture);
  LensGuideStep step() const;
  /// Returns the last image with its tags if the board was at rest in it, otherwise nothing.
  const std::optional<LensView>& resting() const { return resting_; }
  const std::vector<LensView>& views() const { return views_; }
  const Board& board() const { return board_; }

  static constexpr double enough_covered = 0.75;

 private:
  /// Position, tilt and size of the calibration board in an image. A new view must differ from each stored
  /// view in one of them.
  struct BoardAppearance {
    Vec2 middle;  // centre of the tags' bounding box, as a share of the image width
    Vec2 lean;    // mean log ratios of the tags' side lengths, from perspective and foreshortening
    double size;  // longer side of the bounding box, as a share of the image width
  };
  static bool differs(const BoardAppearance& a, const BoardAppearance& b);
  BoardAppearance look_of(const std::vector<DetectedTag>& tags, int width) const;

  Board board_;
  TagDetector finder_;
  std::vector<LensView> views_;
  std::vector<BoardAppearance> looks_;
  std::vector<DetectedTag> last_;
  std::optional<LensView> resting_;
  std::string problem_;
};

}  // namespace prosector
