#pragma once
// Selects the user's face from the faces of successive images. Networks sometimes detect text, covers and
// logos as faces. Their scores can equal those of real faces that turn away.

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/camera/face/eyes_pose.h"

namespace prosector {

struct PlacedFace {
  double score = 0;  // 0 to 1
  EyesPose eyes;
};

/// Tracker that selects the user's face by its position. A face is accepted after half a second with high
/// scores at a plausible distance; from then on a low score suffices. Another face replaces it if that face
/// is much nearer, or after the user's face is lost.
class FaceFollower {
 public:
  /// Processes the faces detected in the image captured at `time_ns`, the largest first. Returns the pose of
  /// the user's eyes, or nothing if the user's face is not among them.
  std::optional<EyesPose> follow(std::span<const PlacedFace> faces, std::int64_t time_ns);

 private:
  struct Track {
    EyesPose eyes;
    std::int64_t first_ns = 0, last_ns = 0;
    int images = 0;
  };
  static bool continues(const std::optional<Track>& track, const EyesPose& eyes, std::int64_t time_ns);
  const PlacedFace* user_among(std::span<const PlacedFace> faces, std::int64_t time_ns) const;
  void try_others(std::span<const PlacedFace> faces, const PlacedFace* user, std::int64_t time_ns);

  std::optional<Track> user_, candidate_;
};

}  // namespace prosector
