#pragma once
// The 21 points of a hand that a network finds in a square around it.

#include <array>

#include "drivers/camera/hands/network.h"
#include "drivers/camera/hands/picture_region.h"

namespace prosector {

/// The wrist, then four of each finger from the thumb on: the thumb's root, knuckle, joint and tip; a
/// finger's knuckle, two joints and tip.
inline constexpr std::size_t hand_points = 21;
using HandPoints = std::array<Vec2, hand_points>;  // pixels
/// Distances of the points along the camera's axis from the wrist's, in pixels at the hand's own distance;
/// positive away from the camera. Rough: they tell a tilt's side better than its angle.
using HandDepths = std::array<double, hand_points>;

struct LandmarkAnswer {
  HandPoints points;    // pixels of the picture
  HandDepths depths{};  // pixels of the picture
  double presence = 0;  // 0 to 1: is it a hand at all
  double right = 0;     // 0 to 1: is it a right one, in a picture that isn't mirrored
};

class LandmarkNetwork {
 public:
  /// Throws InputError where it is another network.
  explicit LandmarkNetwork(NetPlan plan);
  LandmarkAnswer look(const Image& image, const PictureRegion& region);

 private:
  Network network_;
};

/// Returns the square around a hand with these points: fingers up, with room for what moves until the next
/// picture.
PictureRegion region_around(const HandPoints& points);

/// Returns the length of the hand with these points as it would be seen flat, in their unit. It follows from
/// the palm's length or, where the hand points at the camera, its breadth.
double length_of_hand(const HandPoints& points);

}  // namespace prosector
