#pragma once
// Fits the hand model of 14 joints to the points that networks find in images.
//
// Unknown are the wrist's pose (6), five bends and the hand's breadth; the hand's length is known. Solved by
// least squares (Levenberg 1944, Marquardt 1963) with Cauchy weights against outliers. From far away, a flat
// hand tilted one way looks like one tilted the other way. The fit therefore has a start for each tilt
// (compare Huttenlocher and Ullman 1990).

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/hand.h"
#include "common/ids.h"
#include "drivers/camera/hands/hand_landmarks.h"

namespace prosector {

/// Returns the positions of the 21 hand landmarks on the hand model at the given flexions (0 open … 1
/// closed), m, wrist's frame. The thumb's root is no joint of the model, so its position is a guess.
std::array<Vec3, hand_points> points_of_hand(std::size_t hand, const std::array<double, fingers>& flexion);

/// View of a hand by one camera: the landmarks in its image, its lens and its pose.
struct HandView {
  HandPoints points;  // pixels
  Lens lens;
  Pose camera_rig;  // pose of the rig's frame in the camera's frame; the identity for a single camera
  std::optional<HandDepths> depths = std::nullopt;  // as estimated by the network; nothing: unknown
};

struct HandShape {
  std::size_t hand = right_hand;
  double size = 1;  // scale of the hand model; 1 is 190 mm from the wrist to the middle finger's tip
};

struct HandFit {
  Pose wrist;  // in the rig's frame
  std::array<double, fingers> flexion{};
  double breadth = 1;  // breadth divided by that of a hand model of the same length
  double miss = 0;  // RMS distance between the points and the model's points, as a share of the hand's length
                    // in the image
  bool sure = false;  // the points form a plausible hand
};

/// Fits the hand model to the landmarks detected in one or two cameras' images. `before` is the fit of the
/// previous image. A hand that points straight at the camera may have two poses that fit about equally well.
/// The previous pose then decides, else the network's depths, else the better fit. Returns nothing if no view
/// has valid directions for its points, or no start of the fit is possible.
std::optional<HandFit> fit_hand(std::span<const HandView> views, const HandShape& shape,
                                const std::optional<HandFit>& before);

}  // namespace prosector
