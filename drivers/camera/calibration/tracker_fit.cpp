#include "drivers/camera/calibration/tracker_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "common/error.h"

namespace prosector {
namespace {

constexpr int fit_rounds = 15;
constexpr double median_of_three = 1.538;  // median norm of three standard normal numbers
constexpr double fit_huber = 3;            // Mahalanobis distance, over six components
constexpr double most_pair_off = 5;        // Mahalanobis distance; pairs beyond it are left out
constexpr double most_ways_apart = 0.03;   // m, between the results of Shah and of Park and Martin
constexpr double least_place_off = 1e-7,
                 least_turn_off = 1e-7;  // m; rad, per axis: lower bounds due to rounding

using Both = Eigen::Matrix<double, 12, 12>;
using BothMotions = Eigen::Matrix<double, 12, 1>;

cv::Mat turn_to_cv(const Pose& pose) {
  const Mat3 r = pose.q.toRotationMatrix();
  cv::Mat out(3, 3, CV_64F);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) out.at<double>(i, k) = r(i, k);
  return out;
}

cv::Mat place_to_cv(const Pose& pose) {
  return (cv::Mat_<double>(3, 1) << pose.p.x(), pose.p.y(), pose.p.z());
}

Pose from_cv(const cv::Mat& turn, const cv::Mat& place) {
  Mat3 r;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) r(i, k) = turn.at<double>(i, k);
  return {{place.at<double>(0), place.at<double>(1), place.at<double>(2)}, Quat(r).normalized()};
}

/// Pairs of poses in OpenCV's form.
struct CvPairs {
  std::vector<cv::Mat> tracker_turn, tracker_place;  // pose of the tracker in the receiver's frame
  std::vector<cv::Mat> camera_turn, camera_place;    // pose of the camera in the board's frame
  std::vector<cv::Mat> board_turn, board_place;      // pose of the board in the camera's frame
};

CvPairs pairs_to_cv(std::span<const TrackedPair> pairs) {
  CvPairs out;
  for (const TrackedPair& pair : pairs) {
    const Pose tracker = pair.tracker_receiver.inverse(), camera = pair.camera_board.inverse();
    out.tracker_turn.push_back(turn_to_cv(tracker));
    out.tracker_place.push_back(place_to_cv(tracker));
    out.camera_turn.push_back(turn_to_cv(camera));
    out.camera_place.push_back(place_to_cv(camera));
    out.board_turn.push_back(turn_to_cv(pair.camera_board));
    out.board_place.push_back(place_to_cv(pair.camera_board));
  }
  return out;
}

/// The two unknown poses.
struct Chain {
  Pose tracker_camera, receiver_board;
};

Chain fit_by_shah(const CvPairs& pairs) {
  // OpenCV's world is the camera, its base the tracker, its gripper the receiver, and its camera the board.
  cv::Mat turn, place, board_turn, board_place;
  cv::calibrateRobotWorldHandEye(pairs.camera_turn, pairs.camera_place, pairs.tracker_turn,
                                 pairs.tracker_place, turn, place, board_turn, board_place,
                                 cv::CALIB_ROBOT_WORLD_HAND_EYE_SHAH);
  return {from_cv(turn, place).inverse(), from_cv(board_turn, board_place).inverse()};
}

Pose fit_by_park(const CvPairs& pairs) {
  cv::Mat turn, place;
  cv::calibrateHandEye(pairs.tracker_turn, pairs.tracker_place, pairs.board_turn, pairs.board_place, turn,
                       place, cv::CALIB_HAND_EYE_PARK);
  return from_cv(turn, place);
}

/// Difference between a measured receiver pose and the one predicted by the chain: m, rad.
struct Miss {
  Vec3 place, turn;
};

Miss miss_of(const TrackedPair& pair, const Chain& chain) {
  const Pose there = chain.tracker_camera * pair.camera_board * chain.receiver_board.inverse();
  return {pair.tracker_receiver.p - there.p, turn(there.q, pair.tracker_receiver.q)};
}

/// Standard deviations along one axis: m, rad.
struct Scatter {
  double place, turn;

  double length(const Miss& miss) const {
    return std::sqrt(miss.place.squaredNorm() / (place * place) + miss.turn.squaredNorm() / (turn * turn));
  }
};

double middle_one(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Scatter robust_scatter(std::span<const TrackedPair> pairs, const Chain& chain) {
  std::vector<double> places, turns;
  for (const TrackedPair& pair : pairs) {
    const Miss miss = miss_of(pair, chain);
    places.push_back(miss.place.norm());
    turns.push_back(miss.turn.norm());
  }
  return {std::max(least_place_off, middle_one(places) / median_of_three),
          std::max(least_turn_off, middle_one(turns) / median_of_three)};
}

/// Returns the expected scatter of receiver poses. Of 6 numbers per pair, the fit consumes 12 degrees of
/// freedom in all.
Scatter full_scatter(std::span<const TrackedPair> pairs, const Chain& chain) {
  double place = 0, turn = 0;
  for (const TrackedPair& pair : pairs) {
    const Miss miss = miss_of(pair, chain);
    place += miss.place.squaredNorm();
    turn += miss.turn.squaredNorm();
  }
  const double numbers = 3 * (static_cast<double>(pairs.size()) - 2);
  return {std::max(least_place_off, std::sqrt(place / numbers)),
          std::max(least_turn_off, std::sqrt(turn / numbers))};
}

/// Refines the chain by Gauss and Newton's method. Returns the matrix of the normal equations.
Both improve_chain(std::span<const TrackedPair> pairs, bool robust, Chain& chain) {
  Both sum = Both::Zero();
  for (int round = 0; round < fit_rounds; ++round) {
    const Scatter scatter = robust ? robust_scatter(pairs, chain) : full_scatter(pairs, chain);
    sum.setZero();
    BothMotions right = BothMotions::Zero();
    for (const TrackedPair& pair : pairs) {
      const Pose there = chain.tracker_camera * pair.camera_board * chain.receiver_board.inverse();
      const Miss miss = miss_of(pair, chain);
      const double far = scatter.length(miss);
      const double weight = robust && far > fit_huber ? fit_huber / far : 1;
      Eigen::Matrix<double, 3, 12> place, turned;
      const Mat3 r = there.q.toRotationMatrix();
      place << point_jacobian(there.p), Mat3::Zero(), -r;
      turned << Mat3::Identity(), Mat3::Zero(), -r, Mat3::Zero();
      const double by_place = weight / (scatter.place * scatter.place);
      const double by_turn = weight / (scatter.turn * scatter.turn);
      sum += by_place * place.transpose() * place + by_turn * turned.transpose() * turned;
      right += by_place * place.transpose() * miss.place + by_turn * turned.transpose() * miss.turn;
    }
    const BothMotions step = sum.ldlt().solve(right);
    if (!step.allFinite())
      throw InputError(
          "the board's poses do not determine the camera's pose: rotate the board about more axes");
    chain.tracker_camera = moved(chain.tracker_camera, step.head<6>());
    chain.receiver_board = moved(chain.receiver_board, step.tail<6>());
  }
  return sum;
}

/// Checks the rotations. Throws InputError if they are about fewer than two axes.
void check_turns(std::span<const TrackedPair> pairs) {
  const auto n = static_cast<double>(pairs.size());
  std::vector<Vec3> turns;
  Vec3 mean = Vec3::Zero();
  for (const TrackedPair& pair : pairs) {
    turns.push_back(turn(pairs.front().tracker_receiver.q, pair.tracker_receiver.q));
    mean += turns.back() / n;
  }
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& t : turns) scatter += (t - mean) * (t - mean).transpose() / n;
  const Vec3 wide = Eigen::SelfAdjointEigenSolver<Mat3>(scatter, Eigen::EigenvaluesOnly).eigenvalues();
  const double second = std::sqrt(std::max(0.0, wide[1]));
  if (second < min_second_axis_rotation)
    throw InputError(
        fmt::format("the board was rotated about one axis only ({:.1f}° RMS about any other): rotate it "
                    "about two axes, by at least 20° in each direction",
                    second * 180 / std::numbers::pi));
}

void check_count(std::size_t pairs) {
  if (pairs < min_tracked_pairs)
    throw InputError(
        fmt::format("{} poses of the board with its receiver: at least {} are needed, {} are better", pairs,
                    min_tracked_pairs, recommended_tracked_pairs));
}

Vec3 middle_board(std::span<const TrackedPair> pairs) {
  Vec3 out = Vec3::Zero();
  for (const TrackedPair& pair : pairs) out += pair.camera_board.p / static_cast<double>(pairs.size());
  return out;
}

}  // namespace

TrackerFit fit_tracker(std::span<const TrackedPair> pairs) {
  check_count(pairs.size());
  check_turns(pairs);
  TrackerFit fit;
  Chain chain = fit_by_shah(pairs_to_cv(pairs));
  (void)improve_chain(pairs, true, chain);
  const Scatter scatter = robust_scatter(pairs, chain);
  std::vector<TrackedPair> kept;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (scatter.length(miss_of(pairs[i], chain)) <= most_pair_off)
      kept.push_back(pairs[i]);
    else
      fit.left_out.push_back(i);
  }
  check_count(kept.size());
  check_turns(kept);
  const CvPairs good = pairs_to_cv(kept);
  chain = fit_by_shah(good);
  const Vec3 middle = middle_board(kept);
  fit.method_difference = (chain.tracker_camera * middle - fit_by_park(good) * middle).norm();
  if (fit.method_difference > most_ways_apart || 2 * kept.size() < pairs.size())
    throw InputError(
        fmt::format("{} of {} poses of the board fit, and two ways to calculate the camera's pose differ by "
                    "{:.0f} mm: check that the board is fixed to the receiver, that the camera does not "
                    "move, and that no metal is near",
                    kept.size(), pairs.size(), 1e3 * fit.method_difference));
  const Both weighed = improve_chain(kept, false, chain);
  const Both covariance = weighed.ldlt().solve(Both::Identity());
  const Scatter left = full_scatter(kept, chain);
  fit.tracker_camera = chain.tracker_camera;
  fit.receiver_board = chain.receiver_board;
  fit.spread = covariance.topLeftCorner<6, 6>();
  fit.position_rms = std::sqrt(3.0) * left.place;
  fit.rotation_rms = std::sqrt(3.0) * left.turn;
  fit.centre = chain.tracker_camera * middle;
  return fit;
}

}  // namespace prosector
