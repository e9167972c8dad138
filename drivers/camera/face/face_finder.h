#pragma once
// A user's face in a camera's picture, and where the eyes are.

#include <filesystem>
#include <optional>

#include "drivers/camera/hands/anchor_network.h"

namespace prosector {

/// Points of a face, pixels; left and right as the user has them.
struct FoundFace {
  double score = 0;  // 0 to 1
  Vec2 right_eye, left_eye, nose, mouth, right_ear, left_ear;
};

class FaceFinder {
 public:
  /// Takes the network's file from this folder. Throws InputError that says how to get it.
  explicit FaceFinder(const std::filesystem::path& folder);
  /// Returns the largest face of a picture, to some 2 m from a webcam; nothing: there is none.
  std::optional<FoundFace> find(const Image& image);

 private:
  AnchorNetwork network_;
};

/// Where a face's eyes are.
struct EyesPlace {
  Vec3 middle = Vec3::Zero();  // between the eyes, in the camera's frame (x right, y down, z ahead), m
  double yaw = 0;              // rad, of the face from the camera, positive to the picture's right
  double roll = 0;             // rad, from upright, clockwise in the picture
};

/// Returns where the eyes are, for eyes that are 63 mm apart: each per cent that they aren't is one of their
/// distance. The nose tells how far the face is turned.
EyesPlace place_eyes(const FoundFace& face, const Lens& lens);

}  // namespace prosector
