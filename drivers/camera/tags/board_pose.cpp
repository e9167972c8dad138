#include "drivers/camera/tags/board_pose.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "drivers/camera/base/with_cv.h"

namespace prosector {
namespace {

constexpr std::size_t least_corners = 4;
constexpr double outlier_px = 2;         // pixels, and …
constexpr double outlier_ratio = 4;      // … multiple of the median: larger errors are left out
constexpr double most_rms_px = 3;        // pixels; a pose with a larger error is rejected
constexpr double flat_tolerance = 1e-6;  // m

struct Points {
  std::vector<cv::Point3d> board;
  std::vector<cv::Point2d> pixel;
};

Points to_points(std::span<const DetectedCorner> corners) {
  Points out;
  for (const DetectedCorner& corner : corners) {
    out.board.emplace_back(corner.board.x(), corner.board.y(), corner.board.z());
    out.pixel.emplace_back(corner.pixel.x(), corner.pixel.y());
  }
  return out;
}

/// Reports whether the points are in the plane z = 0, as IPPE requires. Points of a three-dimensional board
/// may be, too.
bool are_coplanar(const std::vector<cv::Point3d>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const cv::Point3d& p) { return std::abs(p.z) < flat_tolerance; });
}

std::vector<double> errors(const Pose& camera_board, std::span<const DetectedCorner> corners,
                           const Lens& lens) {
  std::vector<double> out;
  for (const DetectedCorner& corner : corners)
    out.push_back((lens.project(camera_board * corner.board) - corner.pixel).norm());
  return out;
}

std::vector<BoardPose> solve(std::span<const DetectedCorner> corners, const Lens& lens) {
  const Points points = to_points(corners);
  const cv::Matx33d k(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
  std::vector<cv::Mat> turns, places;
  const int method = are_coplanar(points.board) ? cv::SOLVEPNP_IPPE : cv::SOLVEPNP_SQPNP;
  try {
    cv::solvePnPGeneric(points.board, points.pixel, k, cv::noArray(), turns, places, false,
                        static_cast<cv::SolvePnPMethod>(method));
  } catch (const cv::Exception&) {
    return {};  // collinear or coincident points
  }
  std::vector<BoardPose> out;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (!cv::checkRange(turns[i]) || !cv::checkRange(places[i])) continue;
    cv::solvePnPRefineLM(points.board, points.pixel, k, cv::noArray(), turns[i], places[i]);
    if (!cv::checkRange(turns[i]) || !cv::checkRange(places[i])) continue;
    BoardPose pose{pose_of(turns[i], places[i]), 0, 0};
    if (std::any_of(corners.begin(), corners.end(),
                    [&](const DetectedCorner& c) { return (pose.camera_board * c.board).z() <= 0; }))
      continue;
    double sum = 0;
    for (const double e : errors(pose.camera_board, corners, lens)) sum += e * e;
    pose.rms = std::sqrt(sum / static_cast<double>(corners.size()));
    pose.tags = static_cast<int>(corners.size() / 4);
    out.push_back(pose);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const BoardPose& a, const BoardPose& b) { return a.rms < b.rms; });
  return out;
}

std::vector<DetectedCorner> without_outliers(const Pose& pose, std::span<const DetectedCorner> corners,
                                             const Lens& lens) {
  const std::vector<double> off = errors(pose, corners, lens);
  std::vector<double> sorted = off;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double bound = std::max(outlier_px, outlier_ratio * sorted[sorted.size() / 2]);
  std::vector<DetectedCorner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (off[i] <= bound) kept.push_back(corners[i]);
  return kept;
}

}  // namespace

std::vector<DetectedCorner> corners_seen(const Board& board, std::span<const DetectedTag> tags, int* twice) {
  std::vector<DetectedCorner> out;
  for (const DetectedTag& seen : tags) {
    const BoardTag* tag = board.find(seen.code);
    if (tag == nullptr) continue;
    const auto alike = [&](const DetectedTag& t) { return t.code == seen.code; };
    if (std::ranges::count_if(tags, alike) > 1) {
      const bool is_first = &*std::ranges::find_if(tags, alike) == &seen;
      if (twice != nullptr && is_first) ++*twice;
      continue;
    }
    const auto corners = tag->corners();
    for (std::size_t c = 0; c < corners.size(); ++c) out.push_back({corners[c], seen.corners[c]});
  }
  return out;
}

std::vector<BoardPose> solve_board(std::span<const DetectedCorner> corners, const Lens& straight) {
  if (corners.size() < least_corners) return {};
  std::vector<BoardPose> poses = solve(corners, straight);
  if (poses.empty()) return {};
  const std::vector<DetectedCorner> kept = without_outliers(poses.front().camera_board, corners, straight);
  if (kept.size() < corners.size() && kept.size() >= least_corners) poses = solve(kept, straight);
  std::erase_if(poses, [](const BoardPose& pose) { return pose.rms > most_rms_px; });
  if (poses.size() > 2) poses.resize(2);
  return poses;
}

MotionCovariance spread_of(const BoardPose& pose, std::span<const DetectedCorner> corners,
                           const Lens& straight) {
  MotionCovariance sum = MotionCovariance::Zero();
  for (const DetectedCorner& corner : corners) {
    const Vec3 point = pose.camera_board * corner.board;
    const Eigen::Matrix<double, 2, 6> slope = straight.projection_jacobian(point) * point_jacobian(point);
    sum += slope.transpose() * slope;
  }
  return pose.rms * pose.rms / 2 * sum.inverse();  // rms² is the sum over two components
}

}  // namespace prosector
