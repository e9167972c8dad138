#pragma once
// Which of the faces in image after image is the user's. Networks take text, covers and logos for faces now
// and then, with scores that real faces have, too, when they turn away.

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/camera/face/eyes_place.h"

namespace prosector {

struct PlacedFace {
  double score = 0;  // 0 to 1
  EyesPlace eyes;
};

/// Follows one face by its position. A face is believed once it was seen for half a second with a high score,
/// at a distance at which users are; then a low score is enough. Another one takes over that is much nearer,
/// or when the user is gone.
class FaceFollower {
 public:
  /// Takes the faces of an image, the largest first, and the image's time. Returns the user's eyes; nothing:
  /// they aren't seen.
  std::optional<EyesPlace> follow(std::span<const PlacedFace> faces, std::int64_t time_ns);

 private:
  struct Track {
    EyesPlace eyes;
    std::int64_t first_ns = 0, last_ns = 0;
    int images = 0;
  };
  static bool continues(const std::optional<Track>& track, const EyesPlace& eyes, std::int64_t time_ns);
  const PlacedFace* user_among(std::span<const PlacedFace> faces, std::int64_t time_ns) const;
  void try_others(std::span<const PlacedFace> faces, const PlacedFace* user, std::int64_t time_ns);

  std::optional<Track> user_, candidate_;
};

}  // namespace prosector
