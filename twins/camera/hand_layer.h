#pragma once
// Draws the hand model's skin in a synthetic camera's image.

#include "common/hands/hand_skin.h"
#include "common/ids.h"
#include "twins/camera/mesh_layer.h"

namespace prosector {

/// A hand to be drawn in one image of a synthetic camera: side, wrist pose in the camera's frame, flexions,
/// size and skin colour.
struct PosedHand {
  std::size_t hand = right_hand;
  Pose camera_wrist;
  std::array<double, fingers> flexion{};
  double size = 1;                   // scale of the hand model
  Rgb tone = {0.55F, 0.32F, 0.22F};  // colour of the hand's back; the palm is lighter
};

class HandRenderer {
 public:
  /// Builds the skins of the left and the right hand model, which takes some tenths of a second.
  HandRenderer();
  /// Draws hands without motion blur into the depth buffer, in front of its present content where they are
  /// nearer.
  void draw(std::span<const PosedHand> hands, const Lamp& lamp, MeshDepthBuffer& layer) const;

 private:
  struct Paint {
    std::vector<Rgb> of_tone;  // one per vertex, as factors of the tone
  };
  static Paint paint(const HandSkin& skin, std::size_t hand);

  std::array<HandSkin, 2> skins_;
  std::array<Paint, 2> paints_;
};

}  // namespace prosector
