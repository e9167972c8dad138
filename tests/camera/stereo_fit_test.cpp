#include "drivers/camera/calibration/stereo_fit.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/error.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr unsigned stereo_seeds = 60;

/// Noise as a board's edges leave it at 0.6 m: turn, then place across and along the view.
const SmallMotion usual_noise = (SmallMotion() << 4e-4, 4e-4, 1e-4, 1e-5, 1e-5, 7e-5).finished();

/// Returns a board's pose with noise about its own middle.
MeasuredPose measured(Random& random, const Pose& truth) {
  const Pose middle = {truth.p, Quat::Identity()};
  SmallMotion noise;
  for (int i = 0; i < 6; ++i) noise[i] = std::sqrt(3.0) * usual_noise[i] * random.uniform(-1, 1);
  const MotionSpread spread = usual_noise.cwiseAbs2().asDiagonal();
  return {middle * moved(middle.inverse() * truth, noise), spread_in(middle, spread)};
}

struct Rig {
  Pose first_second;
  std::vector<StereoView> views;
};

Rig rig_of(unsigned seed, std::size_t views) {
  Random random(seed);
  Rig rig;
  rig.first_second = {
      Vec3(random.uniform(0.08, 0.3), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03)),
      turned_by(random.point(0.3))};
  for (std::size_t i = 0; i < views; ++i) {
    const Pose board = {{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(0.4, 0.7)},
                        turned_by(random.point(0.5)) * Quat(0, 1, 0, 0)};
    rig.views.push_back({measured(random, board), measured(random, rig.first_second.inverse() * board)});
  }
  return rig;
}

struct RigErrors {
  double place = 0, told = 0;  // m RMS amid the boards
};

RigErrors rig_errors(std::size_t views, bool spoilt = false) {
  const Vec3 target(0, 0, 0.55);
  double squares = 0, told = 0;
  for (unsigned seed = 1; seed <= stereo_seeds; ++seed) {
    Rig rig = rig_of(seed, views);
    if (spoilt) rig.views[2].second_board.pose.p.x() += 0.02;
    const MeanPose fit = fit_stereo(rig.views);
    if (spoilt) {
      EXPECT_EQ(fit.left_out, std::vector<std::size_t>{2});
    }
    squares += (fit.pose * (rig.first_second.inverse() * target) - target).squaredNorm();
    told += std::pow(fit.expected_error(target), 2);
  }
  return {std::sqrt(squares / stereo_seeds), std::sqrt(told / stereo_seeds)};
}

TEST(StereoFit, MoreViewsLeaveLessErrorAndItIsTold) {
  double before = 1;
  for (const std::size_t views : {4u, 10u, 40u}) {
    const RigErrors errors = rig_errors(views);
    std::cout << views << " views: " << 1e3 * errors.place << " mm, told " << 1e3 * errors.told << " mm\n";
    EXPECT_LT(errors.place, 0.8 * before);
    EXPECT_NEAR(errors.told / errors.place, 1, 0.3);
    before = errors.place;
  }
  EXPECT_LT(rig_errors(usual_stereo_views).place, 1e-4);
}

TEST(StereoFit, AViewThatDoesntBelongIsLeftOut) {
  EXPECT_LT(rig_errors(usual_stereo_views, true).place, 1e-4);
}

TEST(StereoFit, SaysWhatToDo) {
  EXPECT_THROW((void)fit_stereo({}), InputError);
  EXPECT_THROW((void)fit_stereo(rig_of(1, 3).views), InputError);
  Random random(3);
  Rig rig = rig_of(1, 8);
  for (StereoView& view : rig.views) view.second_board.pose.p += random.point(0.1);
  // What scatters so is no surprise to a mean: it must then be told as uncertain.
  try {
    EXPECT_GT(fit_stereo(rig.views).expected_error({0, 0, 0.55}), 5e-3);
  } catch (const InputError&) {
  }
}

}  // namespace
}  // namespace prosector
