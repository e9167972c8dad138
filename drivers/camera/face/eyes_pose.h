#pragma once
// Pose of a user's eyes, from the points of a face in an image.

#include "drivers/camera/face/face_detector.h"

namespace prosector {

struct EyesPose {
  Pose head;  // m, pose in the camera's frame (x right, y down, z forward) of a frame with its origin between
              // the eyes: x to the user's right, y up, −z along the gaze
  double yaw = 0;   // rad, of the face from the direction to the camera, positive to the image's right
  double roll = 0;  // rad, from upright, clockwise in the image
};

/// Computes the pose of a user's eyes from the points of a detected face. `eye_distance` is the distance
/// between the eyes, m; its relative error causes an equal relative error of the depth. The yaw follows from
/// the nose's position and is clamped to ±max_yaw.
EyesPose estimate_eyes_pose(const DetectedFace& face, const Lens& lens, double eye_distance);

inline constexpr double max_yaw = 0.9;  // rad
/// Distance of the nose's tip in front of the eyes, as the networks place both in images, divided by the
/// distance between the eyes. The value fits the head of the CT data set and the head model.
inline constexpr double nose_depth_ratio = 0.62;

}  // namespace prosector
