#pragma once
// Network that finds the 21 points of a hand in a square around it.

#include <array>

#include "drivers/camera/nets/image_region.h"
#include "drivers/camera/nets/network.h"

namespace prosector {

/// Number of landmarks of a hand: the wrist, then four points per finger from the thumb on. The thumb has
/// root, knuckle, joint and tip. Each other finger has knuckle, two joints and tip.
inline constexpr std::size_t hand_points = 21;
using HandPoints = std::array<Vec2, hand_points>;  // pixels
/// Depths of a hand's landmarks relative to the wrist, along the camera's axis, in pixels at the hand's own
/// distance. Positive is away from the camera. The values are rough: the direction of a tilt is more reliable
/// than its angle.
using HandDepths = std::array<double, hand_points>;

struct LandmarkAnswer {
  HandPoints points;    // pixels of the image
  HandDepths depths{};  // pixels of the image
  double presence = 0;  // 0 to 1, probability that a hand is visible
  double right = 0;     // 0 to 1, probability of a right hand in an unmirrored image
};

class LandmarkNetwork {
 public:
  /// Prepares the network `plan` for the detection of hand landmarks. Throws InputError if its inputs or
  /// outputs are not those of a hand landmark network.
  explicit LandmarkNetwork(NetPlan plan);
  LandmarkAnswer look(const Image& image, const ImageRegion& region);

 private:
  Network network_;
};

/// Returns the square of the image around a hand with these landmarks, rotated so that the fingers point up.
/// It has a margin for the hand's motion until the next image.
ImageRegion region_around(const HandPoints& points);

/// Returns the length, in pixels, that the hand with these landmarks would have in the image if it faced the
/// camera flat. The estimate uses the palm's length or, when the hand points at the camera, the palm's
/// breadth.
double length_of_hand(const HandPoints& points);

}  // namespace prosector
