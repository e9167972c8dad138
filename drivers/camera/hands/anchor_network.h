#pragma once
// A network that looks at a whole picture at once. Each of its answers belongs to a place of a grid: is a
// thing there, what is its box, and where are points on it?

#include <span>
#include <vector>

#include "drivers/camera/hands/network.h"
#include "drivers/camera/hands/picture_region.h"

namespace prosector {

/// How its answers lie.
struct AnchorLayout {
  struct Grid {
    int side = 0;  // places a side
    int each = 0;  // answers of a place
  };
  std::size_t input = 0;         // pixels a side
  float darkest = 0;             // what it takes black for; white is 1
  std::vector<Grid> grids = {};  // in order
  std::size_t points = 0;        // of an answer
};

/// What it found, in the picture's pixels.
struct AnchoredThing {
  double score = 0;  // 0 to 1
  Vec2 low, high;    // box
  std::vector<Vec2> points;
};

/// Returns how much of what two boxes cover together they both cover.
double overlap(const AnchoredThing& a, const AnchoredThing& b);

class AnchorNetwork {
 public:
  /// Throws InputError where the network has other inputs or outputs; `what` names what it finds.
  AnchorNetwork(NetPlan plan, AnchorLayout layout, const char* what);
  /// Returns things with at least that score that don't overlap, the surest first.
  std::vector<AnchoredThing> find(const Image& image, double least_score);
  /// Looks at a square alone, that isn't turned.
  std::vector<AnchoredThing> find_in(const Image& image, const PictureRegion& square, double least_score);

 private:
  struct Answer {
    double score;
    Eigen::VectorXd values;  // of the input's side: box's centre and size, then x, y of points
  };
  std::vector<Answer> answers(double least_score) const;
  AnchoredThing thing_of(const Answer& answer, const PictureRegion& square) const;

  AnchorLayout layout_;
  std::size_t values_;  // of an answer
  Network network_;
  std::vector<Vec2> anchors_;  // where each answer belongs, 0 to 1
};

}  // namespace prosector
