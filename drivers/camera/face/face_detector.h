#pragma once
// Detects faces in a camera's image.

#include <filesystem>
#include <optional>
#include <vector>

#include "drivers/camera/nets/anchor_network.h"

namespace prosector {

/// Points of a face detected in an image, in pixels, with a score. Left and right are the user's.
struct DetectedFace {
  double score = 0;  // 0 to 1, mean over four close-up searches
  Vec2 right_eye, left_eye, nose, mouth, right_ear, left_ear;
};

class FaceDetector {
 public:
  /// Loads the face detection network's file from `folder`. Throws InputError with advice on how to get the
  /// file.
  explicit FaceDetector(const std::filesystem::path& folder);
  /// Returns the faces detected in an image, the largest first, at most `max_faces`. Faces are detected up to
  /// about 2 m from a webcam.
  std::vector<DetectedFace> find_all(const Image& image);
  /// Returns the largest face detected in an image, or nothing if there is none.
  std::optional<DetectedFace> find(const Image& image);

  static constexpr std::size_t max_faces = 3;

 private:
  std::optional<DetectedFace> detect_close_up(const Image& image, const DetectedObject& rough);

  AnchorDetector network_;
};

}  // namespace prosector
