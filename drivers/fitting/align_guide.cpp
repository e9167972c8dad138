#include "drivers/fitting/align_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "drivers/camera/base/camera_frames.h"

namespace prosector {
namespace {

constexpr StillnessLimits tracker_still = {0.4, 1e-3, 0.01, 10};
constexpr StillnessLimits camera_still = {0.4, 1e-3, 0.01, 4};  // slow cameras deliver few images
constexpr std::int64_t settle_ns = 150'000'000;                 // time for which both must be still
constexpr std::int64_t stale_ns = 300'000'000;                  // age above which a tracker's pose is ignored
constexpr double new_turn = 8 * std::numbers::pi / 180;         // rad, least rotation from every earlier pose
constexpr std::array<const char*, 4> tilt_instructions = {
    "tilt the board's upper side towards the camera", "rotate the board about the viewing direction",
    "tilt the board's left side towards the camera", "tilt the board's lower side towards the camera"};

}  // namespace

AlignGuide::AlignGuide(std::size_t station, std::size_t poses)
    : station_(station), poses_(poses), tracker_(tracker_still), camera_(camera_still) {}

void AlignGuide::take(const DeviceSample& sample) {
  if (sample.station != station_ || !sample.has_trusted_pose()) return;
  tracked_ns_ = sample.time_ns;
  tracker_.take(sample.time_ns, sample.pose);
}

bool AlignGuide::is_new(const Pose& camera_board) const {
  return std::all_of(pairs_.begin(), pairs_.end(), [&](const TrackedPair& pair) {
    return pair.camera_board.q.angularDistance(camera_board.q) >= new_turn;
  });
}

void AlignGuide::add_board_pose(std::int64_t time_ns, const Pose& camera_board) {
  if (pairs_.size() == poses_) return;
  camera_.take(time_ns, camera_board);
  rejection_.clear();
  if (!tracker_.still() || !camera_.still() || time_ns - tracked_ns_ > stale_ns) {
    still_ns_ = 0;
    return;
  }
  if (still_ns_ == 0) still_ns_ = time_ns;
  if (time_ns - still_ns_ < settle_ns) return;
  const TrackedPair pair = {tracker_.mean(), camera_.mean()};
  if (!is_new(pair.camera_board)) {
    rejection_ = "this orientation of the board was used before: rotate it further";
    return;
  }
  pairs_.push_back(pair);
  still_ns_ = 0;
  tracker_.clear();
  camera_.clear();
}

GuideStep AlignGuide::step() const {
  GuideStep out = step_at(pairs_.size(), poses_, rejection_);
  out.progress = std::min(tracker_.filled(), camera_.filled());
  if (!out.done)
    out.instruction = fmt::format("Hold the board in front of the camera, {}, and hold it still",
                                  tilt_instructions[out.index % tilt_instructions.size()]);
  return out;
}

void AlignGuide::back() {
  if (!pairs_.empty()) pairs_.pop_back();
}

GuideOutcome AlignGuide::outcome() const {
  const TrackerFit fit = fit_tracker(pairs_);
  GuideOutcome out;
  out.words.push_back(
      fmt::format("{} poses of the board, {} of them rejected; receiver error {:.2f} mm, {:.2f}° RMS; two "
                  "ways to calculate the camera's pose differ by {:.2f} mm",
                  pairs_.size(), fit.left_out.size(), 1e3 * fit.position_rms,
                  fit.rotation_rms * 180 / std::numbers::pi, 1e3 * fit.method_difference));
  out.words.push_back(fmt::format(
      "expected error of tracked positions: {:.2f} mm RMS where the board was held, {:.2f} mm RMS "
      "at the camera",
      1e3 * fit.expected_error(fit.centre), 1e3 * fit.expected_error(fit.tracker_camera.p)));
  const Pose room_device = fit.tracker_camera * device_camera;
  out.changes = {{"tracker.room.position", written(room_device.p)},
                 {"tracker.room.orientation", written(room_device.q)}};
  return out;
}

}  // namespace prosector
