#pragma once
// Our hand of 14 joints laid through the points that networks find in pictures.
//
// Unknown are the wrist's pose (6), five bends and the hand's breadth; its length is known. Least squares
// after Levenberg (1944) and Marquardt (1963), with Cauchy's weights against single bad points. A flat hand
// seen from far looks the same tilted either way: hence two starts (compare Huttenlocher and Ullman 1990).

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/hand.h"
#include "drivers/camera/hands/hand_landmarks.h"

namespace prosector {

/// Returns where the points are on our hand, in the wrist's frame, m. The thumb's root is no joint of ours:
/// its place is a guess.
std::array<Vec3, hand_points> points_of_hand(std::size_t hand, const std::array<double, fingers>& flexion);

/// What one camera sees of the hand.
struct HandView {
  HandPoints points;  // pixels
  Lens lens;
  Pose camera_rig;  // the frame that the pose is asked in, in the camera's; one camera: none
  std::optional<HandDepths> depths = std::nullopt;  // as the network sees them; nothing: unknown
};

struct HandShape {
  std::size_t hand = right_hand;
  double size = 1;  // of our hand: 1 is 190 mm from the wrist to the middle finger's tip
};

struct HandFit {
  Pose wrist;  // in the rig's frame
  std::array<double, fingers> flexion{};
  double breadth = 1;  // of the hand, where it is as long as ours: 1 is ours
  double miss =
      0;  // rms of the points' distances to our hand's, as a share of the hand's length in the picture
  bool sure = false;  // the points make a hand
};

/// Lays the hand through its points. `before`: where it was in the picture before. A hand that is held
/// straight at the camera may have two poses that fit about equally well. Then the previous pose decides,
/// else the network's depths, else the better fit. Returns nothing where the points can't be looked along.
std::optional<HandFit> fit_hand(std::span<const HandView> views, const HandShape& shape,
                                const std::optional<HandFit>& before);

}  // namespace prosector
