#pragma once
// Pictures of our own skinned hands, as a camera with a bent lens sees them: with truth, light, blur and
// noise.

#include <vector>

#include "common/hand_skin.h"
#include "common/image.h"
#include "drivers/camera/lens.h"
#include "drivers/camera/synthetic/mesh_layer.h"
#include "tests/random.h"

namespace prosector {

struct ShownHand {
  std::size_t hand = right_hand;
  Pose camera_wrist;
  std::array<double, fingers> flexion{};
  Rgb skin = {0.55F, 0.30F, 0.20F};
  double size = 1;
};

struct HandScene {
  Lens lens;
  Pose camera_rig;  // what the hands' poses are in, in the camera's frame
  std::vector<ShownHand> hands;
  Lamp light;
  Rgb wall = {0.3F, 0.32F, 0.35F};
  double noise = 3;  // of 255
};

/// Returns a webcam: 640 × 480, bent as cheap lenses are.
Lens webcam();

/// Returns a hand in a likely pose before the camera: its palm or back shown, turned up to 40° about each
/// axis.
ShownHand random_hand(Random& random, double nearest, double farthest);

/// Returns a lamp, a wall and a tone of skin at random.
HandScene random_scene(Random& random, const ShownHand& hand);

class HandPainter {
 public:
  /// Makes one for pictures by that lens.
  explicit HandPainter(const Lens& lens = webcam());
  Image paint(const HandScene& scene, Random& random) const;

 private:
  Lens lens_;
  std::vector<Eigen::Vector2f> rays_;  // directions, several a pixel
  std::array<HandSkin, 2> skins_;
};

/// Returns where the camera sees a hand's points.
std::array<Vec2, 21> true_points(const HandScene& scene, const ShownHand& hand);

/// Returns the hand's length in the picture when it lies flat before the camera, pixels.
double length_in_picture(const HandScene& scene, const ShownHand& hand);

}  // namespace prosector
