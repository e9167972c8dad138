#pragma once
// Where a face's eyes are, by the points that a picture shows of it.

#include "drivers/camera/face/face_finder.h"

namespace prosector {

struct EyesPlace {
  Pose head;  // in the camera's frame (x right, y down, z ahead), m: from the point between the eyes, the
              // user's right is x, up is y, −z looks ahead
  double yaw = 0;   // rad, of the face from the way to the camera, positive to the picture's right
  double roll = 0;  // rad, from upright, clockwise in the picture
};

/// Returns where the eyes are that are so far apart, m: each per cent that they aren't is one of their
/// distance. The nose tells how far the face is turned; beyond `most_yaw` that says nothing.
EyesPlace place_eyes(const FoundFace& face, const Lens& lens, double eye_distance);

inline constexpr double most_yaw = 0.9;  // rad
/// The nose's tip before the eyes, as networks see both, in distances of the eyes: so on the CT's head and on
/// ours.
inline constexpr double nose_ahead = 0.62;

}  // namespace prosector
