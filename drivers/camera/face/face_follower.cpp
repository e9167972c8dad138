#include "drivers/camera/face/face_follower.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector {
namespace {

constexpr double nearest_face = 0.2, farthest_face = 2;  // m, plausible distances from the camera
constexpr double most_roll = 1;                          // rad; a larger roll is implausible
constexpr double new_score = 0.7,
                 known_score = 0.5;           // least scores to accept a new face and to follow a known one
constexpr double confirmation_seconds = 0.5;  // s for which a face must be seen before it is accepted
constexpr int confirmation_images = 5;
constexpr double longest_gap = 0.5;  // s without a detection, after which a face counts as lost
constexpr double jump_allowance = 0.1,
                 top_speed = 1.5;        // m, m/s: bound on a face's motion between detections
constexpr double takeover_ratio = 0.75;  // ratio of distances below which another face replaces the user's

bool is_plausible(const EyesPose& eyes) {
  const double distance = eyes.head.p.norm();
  return std::abs(eyes.yaw) < max_yaw && std::abs(eyes.roll) < most_roll && distance > nearest_face &&
         distance < farthest_face;
}

double seconds_between(std::int64_t earlier_ns, std::int64_t later_ns) {
  return 1e-9 * static_cast<double>(later_ns - earlier_ns);
}

}  // namespace

bool FaceFollower::continues(const std::optional<Track>& track, const EyesPose& eyes, std::int64_t time_ns) {
  if (!track) return false;
  const double seconds = seconds_between(track->last_ns, time_ns);
  return seconds >= 0 && seconds < longest_gap &&
         (track->eyes.head.p - eyes.head.p).norm() < jump_allowance + top_speed * seconds;
}

/// Returns the face that continues the user's track, nearest to its last position; null if there is none.
const PlacedFace* FaceFollower::user_among(std::span<const PlacedFace> faces, std::int64_t time_ns) const {
  const PlacedFace* best = nullptr;
  const auto step = [&](const PlacedFace& face) { return (face.eyes.head.p - user_->eyes.head.p).norm(); };
  for (const PlacedFace& face : faces)
    if (face.score >= known_score && is_plausible(face.eyes) && continues(user_, face.eyes, time_ns))
      if (best == nullptr || step(face) < step(*best)) best = &face;
  return best;
}

/// Follows the largest other face until it is accepted as the user's or lost.
void FaceFollower::try_others(std::span<const PlacedFace> faces, const PlacedFace* user,
                              std::int64_t time_ns) {
  const auto other = std::find_if(faces.begin(), faces.end(), [&](const PlacedFace& face) {
    return &face != user && face.score >= new_score && is_plausible(face.eyes);
  });
  if (other == faces.end()) return;
  if (!continues(candidate_, other->eyes, time_ns)) candidate_ = Track{other->eyes, time_ns, time_ns, 0};
  candidate_->eyes = other->eyes;
  candidate_->last_ns = time_ns;
  ++candidate_->images;
  if (candidate_->images < confirmation_images ||
      seconds_between(candidate_->first_ns, time_ns) < confirmation_seconds)
    return;
  if (user_ && candidate_->eyes.head.p.norm() > takeover_ratio * user_->eyes.head.p.norm()) return;
  user_ = std::exchange(candidate_, std::nullopt);
}

std::optional<EyesPose> FaceFollower::follow(std::span<const PlacedFace> faces, std::int64_t time_ns) {
  if (user_ && !(seconds_between(user_->last_ns, time_ns) < longest_gap)) user_.reset();
  const PlacedFace* user = user_among(faces, time_ns);
  if (user != nullptr) {
    user_->eyes = user->eyes;
    user_->last_ns = time_ns;
  }
  try_others(faces, user, time_ns);
  if (!user_ || user_->last_ns != time_ns) return std::nullopt;
  return user_->eyes;
}

}  // namespace prosector
