#include "drivers/camera/hands/hand_tracker.h"

#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr std::int64_t max_image_time_gap_ns = 20'000'000;  // most between two cameras' images of one hand
constexpr std::int64_t track_timeout_ns =
    300'000'000;  // time without a pose after which a hand's track restarts
// Bends are smoothed by a low-pass whose cut-off frequency grows with their speed, like poses.
constexpr double bend_least = 2, bend_beta = 3, bend_speed_cut = 2;  // Hz, Hz for each 1/s, Hz

constexpr const char* no_hand = "no hand detected: provide light, and show the whole hand without a glove";
constexpr const char* far_hand =
    "the detected hands are too far away: come nearer, or increase tracker.farthest_hand";
constexpr const char* unclear_pose =
    "a hand is detected, but not its pose: rotate the hand a little, and keep its fingers in the image";

double share_of(double cut, double seconds) {
  return 1 / (1 + 1 / (2 * std::numbers::pi * cut * seconds));
}

}  // namespace

HandTracker::HandTracker(const std::filesystem::path& nets, HandNets effort, std::size_t cameras,
                         const TrackedUser& user)
    : user_(user) {
  for (std::size_t k = 0; k < cameras; ++k) cameras_.push_back({HandFinder(nets, effort), {}, {}});
}

void HandTracker::set_camera_setup(std::size_t camera, const CameraSetup& eye) {
  Camera& it = cameras_.at(camera);
  it.eye = eye;
  it.hands = {};
  it.finder.forget();
  const double length = user_.size * middle_fingertip(right_hand, {}).norm();
  it.finder.set_least_length(eye.lens.fx * length / user_.farthest);
}

void HandTracker::note(Camera& camera, const Frame& frame) {
  for (const DetectedHand& found : camera.finder.find(frame.image))
    camera.hands[found.left ? left_hand : right_hand] = Seen{frame.time_ns, found.points, found.depths};
}

/// Returns whether this camera's images trigger the hand's poses. The first camera that saw the hand recently
/// does.
bool HandTracker::leads(std::size_t camera, std::size_t hand, std::int64_t now_ns) const {
  for (std::size_t before = 0; before < camera; ++before)
    if (const auto& seen = cameras_[before].hands[hand]; seen && now_ns - seen->time_ns < track_timeout_ns)
      return false;
  return true;
}

void HandTracker::smooth(HandTrack& way, const std::array<double, fingers>& flexion, double seconds) {
  if (!way.before || seconds <= 0) {
    way.bends = flexion;
    way.speeds = {};
    return;
  }
  for (std::size_t f = 0; f < fingers; ++f) {
    const double speed = (flexion[f] - way.bends[f]) / seconds;
    way.speeds[f] += share_of(bend_speed_cut, seconds) * (speed - way.speeds[f]);
    way.bends[f] +=
        share_of(bend_least + bend_beta * std::abs(way.speeds[f]), seconds) * (flexion[f] - way.bends[f]);
  }
}

std::optional<TrackedHand> HandTracker::fit(std::size_t camera, std::size_t hand, std::int64_t now_ns) {
  const auto& mine = cameras_[camera].hands[hand];
  if (!mine || mine->time_ns != now_ns || !leads(camera, hand, now_ns)) return std::nullopt;
  std::vector<HandView> views = {
      {mine->points, cameras_[camera].eye.lens, cameras_[camera].eye.camera_rig, mine->depths}};
  for (const Camera& other : cameras_)
    if (&other != &cameras_[camera])
      if (const auto& seen = other.hands[hand];
          seen && std::abs(now_ns - seen->time_ns) < max_image_time_gap_ns)
        views.push_back({seen->points, other.eye.lens, other.eye.camera_rig, seen->depths});
  HandTrack& way = tracks_[hand];
  if (now_ns - way.time_ns > track_timeout_ns) {
    way.before.reset();
    way.jump_filter.forget();
  }
  const auto fitted = fit_hand(views, {hand, user_.size}, way.before);
  if (!fitted || !fitted->sure) return std::nullopt;
  const Vec3 palm = fitted->wrist * Vec3(user_.size * hand_palm(hand).center);
  if (!way.jump_filter.accepts_pose({palm, fitted->wrist.q}, now_ns)) return std::nullopt;
  smooth(way, fitted->flexion, 1e-9 * static_cast<double>(now_ns - way.time_ns));
  way.before = fitted;
  way.time_ns = now_ns;
  return TrackedHand{hand, way.filter.update(fitted->wrist, now_ns), way.bends, fitted->miss, views.size()};
}

std::vector<TrackedHand> HandTracker::see(std::size_t camera, const Frame& frame) {
  Camera& seen_by = cameras_.at(camera);
  note(seen_by, frame);
  std::vector<TrackedHand> out;
  bool is_found = false;
  for (const std::size_t hand : {right_hand, left_hand}) {
    is_found |= seen_by.hands[hand] && seen_by.hands[hand]->time_ns == frame.time_ns;
    if (const auto tracked = fit(camera, hand, frame.time_ns)) out.push_back(*tracked);
  }
  lack_ = !out.empty()                        ? ""
          : is_found                          ? unclear_pose
          : seen_by.finder.ignored_far_hand() ? far_hand
                                              : no_hand;
  return out;
}

}  // namespace prosector
