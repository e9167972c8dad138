#pragma once
// Leads a person through the views of a lens' calibration: picture after picture in, out what to do next.

#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/calibration/lens_fit.h"
#include "drivers/camera/frame.h"

namespace prosector {

struct LensGuideStep {
  std::string instruction;    // what to do now
  std::size_t views = 0;      // that are kept
  double covered = 0;         // share of the picture
  std::vector<SeenTag> seen;  // in the last picture, for who shows it
  bool done = false;
};

class LensGuide {
 public:
  /// Begins. Throws InputError where the board has no tags.
  explicit LensGuide(Board board);

  /// Takes a picture. It is kept where the board rests in it and is seen as in no view before.
  void take(const Image& picture);
  LensGuideStep step() const;
  /// Returns the last picture, where the board rests in it; else nothing.
  const std::optional<LensView>& resting() const { return resting_; }
  const std::vector<LensView>& views() const { return views_; }
  const Board& board() const { return board_; }

  static constexpr double enough_covered = 0.75;

 private:
  /// How the board lies in a picture: what must differ from view to view.
  struct Look {
    Vec2 middle;  // of the picture's width
    Vec2 lean;    // how its left and right, lower and upper sides differ in length
    double size;  // of the picture's width
  };
  static bool differs(const Look& a, const Look& b);
  Look look_of(const std::vector<SeenTag>& tags, int width) const;

  Board board_;
  TagFinder finder_;
  std::vector<LensView> views_;
  std::vector<Look> looks_;
  std::vector<SeenTag> last_;
  std::optional<LensView> resting_;
  std::string trouble_;
};

}  // namespace prosector
