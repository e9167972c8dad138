#include "drivers/camera/tags/board_tracker.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <opencv2/video/tracking.hpp>

namespace prosector {
namespace {

constexpr double alike_ratio =
    3;  // of both poses' errors: where they look so alike, the nearer to the last one is right
constexpr double alike_px = 0.3;      // … or both errors are below this
constexpr double flow_back_px = 0.7;  // that a corner may miss its start by when it is followed back
constexpr int flow_window = 15;       // pixels
constexpr int flow_levels = 3;
constexpr double corner_deviation = 2e-3;  // m, of a pose by corners alone
constexpr double unfitted_px = 0.5;        // that such a pose counts as off
constexpr double doubt_kept = 0.95;        // of the doubt, from picture to picture
constexpr double enough_doubt = 6;         // logarithm of how much likelier another pose must be

cv::Mat wrapped(const GreyImage& image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.grey.data())};
}

}  // namespace

BoardTracker::BoardTracker(Board board) : board_(std::move(board)) {}

BoardTracker::Fitted BoardTracker::fit(const BoardPose& pose, const TagPicture& picture,
                                       const TagOptics& optics, const std::vector<int>& codes) const {
  if (const auto edges =
          fit_edges(picture.bent, optics.bent, board_, codes, pose.camera_board, optics.response)) {
    const Mat3 place = edges->covariance.bottomRightCorner<3, 3>();
    const double worst = Eigen::SelfAdjointEigenSolver<Mat3>(place, Eigen::EigenvaluesOnly).eigenvalues()[2];
    return {edges->camera_board, edges->rms, std::sqrt(worst), edges->samples, edges->covariance};
  }
  return {pose.camera_board, std::max(pose.rms, unfitted_px), corner_deviation, 0, {}};
}

std::optional<BoardTracker::Fitted> BoardTracker::choose(const std::vector<BoardPose>& poses,
                                                         const TagPicture& picture, const TagOptics& optics,
                                                         const std::vector<int>& codes) {
  if (poses.empty()) return std::nullopt;
  Fitted first = fit(poses[0], picture, optics, codes);
  const bool alike =
      poses.size() > 1 && (poses[1].rms < alike_ratio * poses[0].rms || poses[1].rms < alike_px);
  if (!alike) {
    doubt_ = 0;
    return first;
  }
  Fitted second = fit(poses[1], picture, optics, codes);
  if (!last_) {
    doubt_ = 0;
    return second.rms < first.rms ? second : first;
  }
  const auto turned = [&](const Fitted& one) {
    return one.camera_board.q.angularDistance(last_->camera_board.q);
  };
  if (turned(second) < turned(first)) std::swap(first, second);
  // The logarithm of how much likelier the other one is; one picture says little, so it adds up.
  doubt_ = doubt_kept * doubt_ + std::min(first.samples, second.samples) * std::log(first.rms / second.rms);
  if (doubt_ < enough_doubt) return first;
  doubt_ = 0;
  return second;
}

std::vector<SeenCorner> BoardTracker::follow(const TagPicture& picture, const TagOptics& optics) const {
  std::vector<Vec3> corners;
  std::vector<cv::Point2f> from, to, back;
  for (const int code : last_->codes)
    for (const Vec3& corner : board_.find(code)->corners()) {
      const Vec2 at = optics.straight.project(last_->camera_board * corner);
      if (!optics.straight.sees(at)) continue;
      corners.push_back(corner);
      from.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()));
    }
  if (from.empty() || last_->straight.width != picture.straight.width ||
      last_->straight.height != picture.straight.height)
    return {};
  std::vector<std::uint8_t> found, found_back;
  const cv::Size window(flow_window, flow_window);
  const cv::Mat before = wrapped(last_->straight), now = wrapped(picture.straight);
  cv::calcOpticalFlowPyrLK(before, now, from, to, found, cv::noArray(), window, flow_levels);
  cv::calcOpticalFlowPyrLK(now, before, to, back, found_back, cv::noArray(), window, flow_levels);
  std::vector<SeenCorner> out;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (found[i] != 0 && found_back[i] != 0 && cv::norm(back[i] - from[i]) < flow_back_px)
      out.push_back({corners[i], {to[i].x, to[i].y}});
  return out;
}

std::optional<TrackedBoard> BoardTracker::update(const TagPicture& picture, const TagOptics& optics) {
  TrackedBoard out;
  std::vector<SeenCorner> corners = corners_seen(board_, picture.tags, &out.twice);
  std::vector<int> codes;
  if (!corners.empty()) {
    for (const SeenTag& tag : picture.tags)
      if (board_.find(tag.code) != nullptr) codes.push_back(tag.code);
  } else {
    const bool may_follow = last_ && out.twice == 0 &&
                            static_cast<double>(picture.time_ns - last_->read_ns) * 1e-9 < longest_followed;
    if (may_follow) corners = follow(picture, optics);
    out.followed = true;
    if (last_) codes = last_->codes;
  }
  const auto found = choose(solve_board(corners, optics.straight), picture, optics, codes);
  if (!found) {
    forget();
    return std::nullopt;
  }
  if (out.followed && found->samples == 0) {  // flow alone goes astray: edges must bear it out
    forget();
    return std::nullopt;
  }
  out.camera_board = found->camera_board;
  out.deviation = found->deviation;
  if (found->samples > 0) out.spread = found->spread;
  last_ = Last{out.camera_board, out.followed ? last_->read_ns : picture.time_ns, picture.straight,
               std::move(codes)};
  return out;
}

}  // namespace prosector
