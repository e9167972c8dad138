#include "drivers/camera/tags/board_tracker.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "drivers/camera/tags/flow.h"

namespace prosector {
namespace {

constexpr double alike_ratio = 3;  // ratio of the two poses' errors; below it they are ambiguous, and the
                                   // pose nearer to the last one is chosen
constexpr double alike_px = 0.3;   // pixels; the poses are also ambiguous if the second error is below this
constexpr double corner_deviation = 2e-3;   // m, assumed deviation of a pose from corners only
constexpr double unfitted_px = 0.5;         // pixels, least error assumed for a pose from corners only
constexpr double likelihood_decay = 0.95;   // decay factor of the log likelihood ratio per image
constexpr double likelihood_threshold = 6;  // log likelihood ratio at which the other pose is chosen

/// Returns the standard deviation of the position along its worst direction, m.
double worst_deviation(const MotionCovariance& spread) {
  const Mat3 place = spread.bottomRightCorner<3, 3>();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Mat3>(place, Eigen::EigenvaluesOnly).eigenvalues()[2]);
}

}  // namespace

BoardTracker::BoardTracker(Board board) : board_(std::move(board)) {
  if (board_.picture) target_ = std::make_shared<const ImageTarget>(board_);
}

BoardTracker::Fitted BoardTracker::fit(const BoardPose& pose, const TagImage& picture,
                                       const TagOptics& optics, const Seen& seen) const {
  if (target_) {
    const MotionCovariance spread = spread_of(pose, seen.corners, optics.straight);
    return {pose.camera_board, pose.rms, worst_deviation(spread), static_cast<int>(seen.corners.size()),
            spread};
  }
  if (const auto edges =
          fit_edges(picture.bent, optics.bent, board_, seen.codes, pose.camera_board, optics.response))
    return {edges->camera_board, edges->rms, worst_deviation(edges->covariance), edges->samples,
            edges->covariance};
  return {pose.camera_board, std::max(pose.rms, unfitted_px), corner_deviation, 0, {}};
}

std::optional<BoardTracker::Fitted> BoardTracker::choose(const TagImage& picture, const TagOptics& optics,
                                                         const Seen& seen) {
  const std::vector<BoardPose> poses = solve_board(seen.corners, optics.straight);
  if (poses.empty()) return std::nullopt;
  Fitted first = fit(poses[0], picture, optics, seen);
  const bool alike =
      poses.size() > 1 && (poses[1].rms < alike_ratio * poses[0].rms || poses[1].rms < alike_px);
  if (!alike) {
    log_likelihood_ratio_ = 0;
    return first;
  }
  Fitted second = fit(poses[1], picture, optics, seen);
  if (!last_) {
    log_likelihood_ratio_ = 0;
    return second.rms < first.rms ? second : first;
  }
  const auto turned = [&](const Fitted& one) {
    return one.camera_board.q.angularDistance(last_->camera_board.q);
  };
  if (turned(second) < turned(first)) std::swap(first, second);
  // Accumulates the log likelihood ratio over images, because a single image isn't conclusive.
  log_likelihood_ratio_ = likelihood_decay * log_likelihood_ratio_ +
                          std::min(first.samples, second.samples) * std::log(first.rms / second.rms);
  if (log_likelihood_ratio_ < likelihood_threshold) return first;
  log_likelihood_ratio_ = 0;
  return second;
}

std::vector<DetectedCorner> BoardTracker::follow(const TagImage& picture, const TagOptics& optics) const {
  std::vector<Vec3> corners;
  std::vector<Vec2> from;
  for (const int code : last_->codes)
    for (const Vec3& corner : board_.find(code)->corners()) {
      const Vec2 at = optics.straight.project(last_->camera_board * corner);
      if (!optics.straight.sees(at)) continue;
      corners.push_back(corner);
      from.push_back(at);
    }
  if (last_->straight.width != picture.straight.width || last_->straight.height != picture.straight.height)
    return {};
  const auto to = follow_places(last_->straight, picture.straight, from);
  std::vector<DetectedCorner> out;
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i]) out.push_back({corners[i], *to[i]});
  return out;
}

BoardTracker::Seen BoardTracker::look_for_tags(const TagImage& picture, const TagOptics& optics) const {
  Seen seen;
  seen.corners = corners_seen(board_, picture.tags, &seen.twice);
  if (!seen.corners.empty()) {
    for (const DetectedTag& tag : picture.tags)
      if (board_.find(tag.code) != nullptr && std::ranges::find(seen.codes, tag.code) == seen.codes.end())
        seen.codes.push_back(tag.code);
    return seen;
  }
  seen.followed = true;
  if (!last_) return seen;
  seen.codes = last_->codes;
  if (seen.twice == 0 && static_cast<double>(picture.time_ns - last_->read_ns) * 1e-9 < max_flow_time)
    seen.corners = follow(picture, optics);
  return seen;
}

BoardTracker::Seen BoardTracker::look_for_picture(const TagImage& picture, const TagOptics& optics) {
  Seen seen;
  const auto looks_near = [&](const Pose& pose) {
    seen.corners = target_->follow(picture.straight, optics.straight, pose);
    return !seen.corners.empty();
  };
  if (last_ && looks_near(last_->camera_board)) return seen;
  // A search is slow, so it isn't run for every image.
  if (searched_ns_ && std::abs(static_cast<double>(picture.time_ns - *searched_ns_)) * 1e-9 < search_interval)
    return seen;
  searched_ns_ = picture.time_ns;
  for (const BoardPose& pose : solve_board(target_->find(picture.straight), optics.straight))
    if (looks_near(pose.camera_board)) break;
  return seen;
}

std::optional<TrackedBoard> BoardTracker::update(const TagImage& picture, const TagOptics& optics) {
  Seen seen = target_ ? look_for_picture(picture, optics) : look_for_tags(picture, optics);
  const auto found = choose(picture, optics, seen);
  if (!found || (seen.followed && found->samples == 0)) {  // flow alone drifts; edges must confirm it
    forget();
    return std::nullopt;
  }
  TrackedBoard out{found->camera_board, found->deviation, {}, seen.followed, seen.twice};
  if (found->samples > 0) out.spread = found->spread;
  last_ = Last{out.camera_board, seen.followed ? last_->read_ns : picture.time_ns, picture.straight,
               std::move(seen.codes)};
  return out;
}

}  // namespace prosector
