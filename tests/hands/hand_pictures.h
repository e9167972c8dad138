#pragma once
// Pictures of our own skinned hands, as a camera with a bent lens sees them: with truth, light, blur and
// noise.

#include <vector>

#include "common/image.h"
#include "drivers/camera/base/lens.h"
#include "tests/random.h"
#include "twins/camera/hand_layer.h"

namespace prosector {

struct HandScene {
  Lens lens;
  Pose camera_rig;  // what the hands' poses are in, in the camera's frame
  std::vector<PosedHand> hands;
  Lamp light;
  Rgb wall = {0.3F, 0.32F, 0.35F};
  double noise = 3;  // of 255
};

/// Returns a webcam: 640 × 480, bent as cheap lenses are.
Lens webcam();

/// Returns a hand in a likely pose before the camera: its palm or back shown, turned up to 40° about each
/// axis.
PosedHand random_hand(Random& random, double nearest, double farthest);

/// Returns a lamp, a wall and a tone of skin at random.
HandScene random_scene(Random& random, const PosedHand& hand);

class HandPainter {
 public:
  /// Makes one for pictures by that lens.
  explicit HandPainter(const Lens& lens = webcam());
  Image paint(const HandScene& scene, Random& random) const;

 private:
  Lens lens_;
  std::vector<Eigen::Vector2f> rays_;  // directions, several a pixel
  HandRenderer layer_;
};

/// Returns where the camera sees a hand's points.
std::array<Vec2, 21> true_points(const HandScene& scene, const PosedHand& hand);

/// Returns the hand's length in the picture when it lies flat before the camera, pixels.
double length_in_picture(const HandScene& scene, const PosedHand& hand);

}  // namespace prosector
