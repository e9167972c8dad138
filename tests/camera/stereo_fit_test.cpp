#include "drivers/camera/calibration/stereo_fit.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/error.h"
#include "drivers/camera/calibration/stereo_guide.h"
#include "drivers/camera/tags/standard_boards.h"
#include "tests/camera/tag_cases.h"

namespace prosector {
namespace {

constexpr unsigned mean_seeds = 60;

/// Noise as two boards' edges leave it at 0.6 m: turn, then place across and along the view.
const SmallMotion usual_noise = (SmallMotion() << 4e-4, 4e-4, 1e-4, 1e-5, 1e-5, 7e-5).finished();

MeasuredPose measured(Random& random, const Pose& truth) {
  SmallMotion noise;
  for (int i = 0; i < 6; ++i) noise[i] = std::sqrt(3.0) * usual_noise[i] * random.uniform(-1, 1);
  return {moved(truth, noise), usual_noise.cwiseAbs2().asDiagonal()};
}

struct MeanErrors {
  double place = 0, told = 0;  // m RMS at a target
};

MeanErrors mean_errors(std::size_t poses, bool spoilt) {
  const Vec3 target(0, 0, 0.55);
  double squares = 0, told = 0;
  for (unsigned seed = 1; seed <= mean_seeds; ++seed) {
    Random random(seed);
    const Pose truth = {random.point(0.2), rotated_by(random.point(0.3))};
    std::vector<MeasuredPose> all;
    for (std::size_t k = 0; k < poses; ++k) all.push_back(measured(random, truth));
    if (spoilt) all[2].pose.p.x() += 0.02;
    const MeanPose mean = mean_pose(all);
    EXPECT_EQ(mean.left_out, spoilt ? std::vector<std::size_t>{2} : std::vector<std::size_t>{});
    squares += (mean.pose * (truth.inverse() * target) - target).squaredNorm();
    told += std::pow(mean.expected_error(target), 2);
  }
  return {std::sqrt(squares / mean_seeds), std::sqrt(told / mean_seeds)};
}

TEST(MeanPose, MorePosesLeaveLessErrorAndItIsTold) {
  double before = 1;
  for (const std::size_t poses : {4u, 10u, 40u}) {
    const MeanErrors errors = mean_errors(poses, false);
    EXPECT_LT(errors.place, 0.8 * before);
    EXPECT_NEAR(errors.told / errors.place, 1, 0.3);
    before = errors.place;
  }
}

TEST(MeanPose, WhatDoesntBelongIsLeftOut) {
  EXPECT_LT(mean_errors(10, true).place, 1.2 * mean_errors(10, false).place);
  EXPECT_THROW((void)mean_pose({}), InputError);
}

/// Two cameras of different lenses, 12 cm apart, before which a board is shown.
class Rig {
 public:
  Rig() {
    lenses_[1].fx = lenses_[1].fy = 560;
    lenses_[1].cx = 310;
    lenses_[1].k1 = -0.1;
    rooms_[1] = {{0.12, 0.01, 0.005}, Quat(Eigen::AngleAxisd(0.15, Vec3::UnitY()))};
  }
  Pose first_second() const { return device_camera * rooms_[0].inverse() * rooms_[1] * device_camera; }
  CameraCalibration calibration(std::size_t camera) const { return {"synthetic", lenses_[camera], 2.2, 0}; }
  Image see(std::size_t camera, const Pose& room_board, unsigned seed) const {
    SyntheticScene scene = usual_scene(lenses_[camera]);
    scene.rays = 2;
    scene.sensor.seed = seed;
    scene.camera.pose = rooms_[camera];
    Carrier carrier;
    carrier.pose = room_board;
    scene.add_board(find_board("calibration"), carrier);
    return SceneRenderer(scene).paint(0);
  }

 private:
  std::array<Lens, 2> lenses_ = {usual_lens(), usual_lens()};
  std::array<Pose, 2> rooms_;
};

/// Holds the board still at places, as a person is asked to; the second camera's clock is so far ahead.
void show(const Rig& rig, StereoGuide& guide, unsigned places, std::int64_t ahead_ns) {
  Random random(9);
  for (unsigned place = 0; place < places; ++place) {
    const double distance = random.uniform(0.42, 0.5);
    Pose board = board_before_camera(random, distance, 0.15, 0.6);
    board.p.x() = 0.06 + random.uniform(-0.04, 0.04);
    board.p.y() = random.uniform(-0.04, 0.04);
    const std::array<Image, 2> seen = {rig.see(0, board, 2 * place + 1), rig.see(1, board, 2 * place + 2)};
    for (int k = 0; k < 2; ++k)
      for (std::size_t camera = 0; camera < 2; ++camera)
        guide.take(camera, {seen[camera], 100'000'000LL * (10 * place + static_cast<unsigned>(k)) +
                                              static_cast<std::int64_t>(camera) * ahead_ns});
  }
}

TEST(StereoFit, TwoCamerasAreFoundWhereTheyStand) {
  const Rig rig;
  const Board board = find_board("calibration");
  StereoGuide guide(board);
  show(rig, guide, 10, 15'000'000);
  ASSERT_GE(guide.pairs().size(), 8u);
  const StereoFit fit = fit_stereo(board, guide.pairs(), rig.calibration(0), rig.calibration(1));
  const Vec3 off = fit.first_second.pose.p - rig.first_second().p;
  EXPECT_LT(off.norm(), 3e-4);
  EXPECT_LT(fit.first_second.pose.q.angularDistance(rig.first_second().q), 0.03 * degree);
  EXPECT_GT(fit.held_out, 0);
  EXPECT_LT(fit.held_out, 0.2);
  EXPECT_LT(fit.expected_error, 3e-4);
  // A board that was moved between both pictures of a pair is left out.
  std::vector<StereoPair> pairs = guide.pairs();
  pairs[3].second = pairs[5].second;
  const StereoFit spoilt = fit_stereo(board, pairs, rig.calibration(0), rig.calibration(1));
  EXPECT_EQ(spoilt.first_second.left_out, std::vector<std::size_t>{3});
  EXPECT_LT((spoilt.first_second.pose.p - rig.first_second().p).norm(), 4e-4);
  // What can't be, is said.
  EXPECT_THROW((void)fit_stereo(board, std::span(pairs).first(3), rig.calibration(0), rig.calibration(1)),
               InputError);
}

TEST(StereoGuide, PicturesThatAreFarApartMakeNoPair) {
  const Rig rig;
  StereoGuide guide(find_board("calibration"));
  show(rig, guide, 2, 80'000'000);
  EXPECT_TRUE(guide.pairs().empty());
  EXPECT_GT(guide.step().views[0], 0u);
  EXPECT_NE(guide.step().instruction.find("50 ms apart"), std::string::npos) << guide.step().instruction;
}

}  // namespace
}  // namespace prosector
