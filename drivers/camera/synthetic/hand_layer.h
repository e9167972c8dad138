#pragma once
// Our own hands' skin before a synthetic camera.

#include "common/hand_skin.h"
#include "drivers/camera/lens.h"
#include "drivers/camera/synthetic/mesh_layer.h"

namespace prosector {

/// How a hand is, as one picture shows it.
struct BentHand {
  std::size_t hand = right_hand;
  Pose camera_wrist;
  std::array<double, fingers> flexion{};
  double size = 1;                   // 1: our hand
  Rgb tone = {0.55F, 0.32F, 0.22F};  // of the back; the palm is lighter
};

class HandLayer {
 public:
  /// Makes one for pictures by that lens. Takes some tenths of a second.
  explicit HandLayer(const Lens& lens);
  /// Draws hands, none blurred by motion.
  MeshLayer draw(std::span<const BentHand> hands, const Lamp& lamp) const;

 private:
  struct Paint {
    std::vector<Rgb> of_tone;  // of each vertex, as factors of the tone
  };
  static Paint paint(const HandSkin& skin, std::size_t hand);

  int width_, height_;          // cells
  Eigen::Vector2d low_, high_;  // directions that the lens sees
  std::array<HandSkin, 2> skins_;
  std::array<Paint, 2> paints_;
};

}  // namespace prosector
