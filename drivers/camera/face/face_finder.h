#pragma once
// A user's face in a camera's picture.

#include <filesystem>
#include <optional>
#include <vector>

#include "drivers/camera/hands/anchor_network.h"

namespace prosector {

/// Points of a face, pixels; left and right as the user has them.
struct FoundFace {
  double score = 0;  // 0 to 1, in the mean of several looks
  Vec2 right_eye, left_eye, nose, mouth, right_ear, left_ear;
};

class FaceFinder {
 public:
  /// Takes the network's file from this folder. Throws InputError that says how to get it.
  explicit FaceFinder(const std::filesystem::path& folder);
  /// Returns the faces of a picture, to some 2 m from a webcam, the largest first, at most `most_faces`.
  std::vector<FoundFace> find_all(const Image& image);
  /// Returns the largest face of a picture; nothing: there is none.
  std::optional<FoundFace> find(const Image& image);

  static constexpr std::size_t most_faces = 3;

 private:
  std::optional<FoundFace> look_closer(const Image& image, const AnchoredThing& rough);

  AnchorNetwork network_;
};

}  // namespace prosector
