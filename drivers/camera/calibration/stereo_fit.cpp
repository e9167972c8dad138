#include "drivers/camera/calibration/stereo_fit.h"

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"
#include "drivers/camera/tags/edge_fit.h"

namespace prosector {
namespace {

constexpr std::size_t unfitted_interval = 5;

/// Poses of one board in both cameras' frames.
struct PairPoses {
  MeasuredPose first_board, second_board;

  MeasuredPose first_second() const {
    const Pose pose = first_board.pose * second_board.pose.inverse();
    return {pose, first_board.spread + transform_covariance(pose, second_board.spread)};
  }
};

std::optional<MeasuredPose> board_in(const Board& board, const LensView& view,
                                     const CameraCalibration& camera) {
  std::vector<DetectedCorner> corners = corners_seen(board, view.tags);
  for (DetectedCorner& corner : corners) corner.pixel = camera.lens.undistorted_pixel(corner.pixel);
  const auto poses = solve_board(corners, camera.lens.pinhole());
  if (poses.empty()) return std::nullopt;
  std::vector<int> codes;
  for (const DetectedTag& tag : view.tags) codes.push_back(tag.code);
  const auto fit =
      fit_edges(view.picture, camera.lens, board, codes, poses.front().camera_board, camera.response);
  if (!fit) return std::nullopt;
  return MeasuredPose{fit->camera_board, fit->covariance};
}

MeanPose mean_of(std::span<const PairPoses> pairs) {
  std::vector<MeasuredPose> seconds;
  for (const PairPoses& pair : pairs) seconds.push_back(pair.first_second());
  return mean_pose(seconds);
}

/// Returns the RMS pixel distance in the second camera between corners predicted by the first camera and
/// corners of the measured board pose.
double pair_error(const Board& board, std::span<const PairPoses> pairs, const Pose& first_second,
                  const Lens& second) {
  double sum = 0;
  int count = 0;
  for (const PairPoses& pair : pairs)
    for (const BoardTag& tag : board.tags)
      for (const Vec3& corner : tag.corners()) {
        const Vec3 corner_in_second = first_second.inverse() * (pair.first_board.pose * corner);
        sum += (second.project(corner_in_second) - second.project(pair.second_board.pose * corner))
                   .squaredNorm();
        ++count;
      }
  return count == 0 ? 0 : std::sqrt(sum / count);
}

}  // namespace

StereoFit fit_stereo(const Board& board, std::span<const StereoPair> pairs, const CameraCalibration& first,
                     const CameraCalibration& second) {
  std::vector<PairPoses> all, fitted, left_out;
  for (const StereoPair& pair : pairs) {
    const auto a = board_in(board, pair.first, first), b = board_in(board, pair.second, second);
    if (!a || !b) continue;
    all.push_back({*a, *b});
    (all.size() % unfitted_interval == 0 ? left_out : fitted).push_back(all.back());
  }
  if (all.size() < min_stereo_pairs)
    throw InputError(
        fmt::format("{} views show the board to both cameras: at least {} are needed, {} are better; hold "
                    "the board still in view of both",
                    all.size(), min_stereo_pairs, recommended_stereo_pairs));
  StereoFit out;
  out.first_second = mean_of(all);
  out.held_out = pair_error(board, left_out, mean_of(fitted).pose, second.lens);
  Vec3 middle = Vec3::Zero();
  for (const PairPoses& pair : all) middle += pair.first_board.pose.p / static_cast<double>(all.size());
  out.expected_error = out.first_second.expected_error(middle);
  return out;
}

}  // namespace prosector
