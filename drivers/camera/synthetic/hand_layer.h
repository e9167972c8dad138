#pragma once
// Our own hands' skin before a synthetic camera.

#include "common/hand_skin.h"
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
  /// Takes some tenths of a second.
  HandLayer();
  /// Draws hands, none blurred by motion, over what is there.
  void draw(std::span<const BentHand> hands, const Lamp& lamp, MeshLayer& layer) const;

 private:
  struct Paint {
    std::vector<Rgb> of_tone;  // of each vertex, as factors of the tone
  };
  static Paint paint(const HandSkin& skin, std::size_t hand);

  std::array<HandSkin, 2> skins_;
  std::array<Paint, 2> paints_;
};

}  // namespace prosector
