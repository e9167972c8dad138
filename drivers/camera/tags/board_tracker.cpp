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
constexpr double unread_deviation = 2e-3;  // m, of a pose by corners alone

cv::Mat wrapped(const GreyImage& image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.grey.data())};
}

}  // namespace

BoardTracker::BoardTracker(Board board) : board_(std::move(board)) {}

std::optional<BoardPose> BoardTracker::choose(const std::vector<BoardPose>& poses) const {
  if (poses.empty()) return std::nullopt;
  if (poses.size() < 2 || !last_) return poses.front();
  const bool alike = poses[1].rms < alike_ratio * poses[0].rms || poses[1].rms < alike_px;
  if (!alike) return poses.front();
  const auto turned = [&](const BoardPose& pose) {
    return pose.camera_board.q.angularDistance(last_->camera_board.q);
  };
  return turned(poses[1]) < turned(poses[0]) ? poses[1] : poses[0];
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
  const auto pose = choose(solve_board(corners, optics.straight));
  if (!pose) {
    forget();
    return std::nullopt;
  }
  out.camera_board = pose->camera_board;
  out.deviation = unread_deviation;
  if (const auto fit =
          fit_edges(picture.bent, optics.bent, board_, codes, pose->camera_board, optics.response)) {
    out.camera_board = fit->camera_board;
    out.spread = fit->covariance;
    const Mat3 place = fit->covariance.bottomRightCorner<3, 3>();
    out.deviation =
        std::sqrt(Eigen::SelfAdjointEigenSolver<Mat3>(place, Eigen::EigenvaluesOnly).eigenvalues()[2]);
  } else if (out.followed) {
    forget();  // flow alone would drift
    return std::nullopt;
  }
  last_ = Last{out.camera_board, out.followed ? last_->read_ns : picture.time_ns, picture.straight,
               std::move(codes)};
  return out;
}

}  // namespace prosector
