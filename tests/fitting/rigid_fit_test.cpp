#include "drivers/fitting/rigid_fit.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <iostream>

#include "common/error.h"
#include "tests/fitting/simulated_tracker.h"

namespace prosector {
namespace {

std::vector<TouchedPoint> touch(SimulatedTracker& tracker, const Pose& room_device,
                                std::span<const Vec3> places, double noise) {
  std::vector<TouchedPoint> points;
  for (const Vec3& place : places)
    points.push_back({room_device.inverse() * place + tracker.noise(noise), place});
  return points;
}

double rms(double squares, int trials) {
  return std::sqrt(squares / trials);
}

TEST(RigidFit, FindsTheExactPoseWithoutNoise) {
  SimulatedTracker tracker(1);
  const Pose truth = {tracker.inside(1), tracker.orientation()};
  std::vector<Vec3> places;
  for (int i = 0; i < 4; ++i) places.push_back(tracker.inside(0.3));
  const RigidFit fit = fit_rigid(touch(tracker, truth, places, 0));
  EXPECT_LT((fit.room_device.p - truth.p).norm(), 1e-12);
  EXPECT_LT(fit.room_device.q.angularDistance(truth.q), 1e-7);
  EXPECT_LT(fit.fre, 1e-12);
}

// The truth is known here, so the formula's error and the true one can be compared: over many trials, at
// targets that were never touched.
TEST(RigidFit, TrueErrorAtATargetIsTheOneInTheory) {
  for (const int count : {4, 6, 10, 20}) {
    SimulatedTracker tracker(static_cast<unsigned>(count));
    std::vector<Vec3> places;
    for (int i = 0; i < count; ++i) places.push_back(tracker.inside(0.3));
    const std::array<Vec3, 3> targets = {Vec3(0.3, 0.3, 0.3), Vec3(0, 0, 0), Vec3(-0.3, 0.1, 0.2)};
    constexpr int trials = 4000;
    std::array<double, 3> squares{}, theory{};
    double fre = 0, fle = 0;
    for (int k = 0; k < trials; ++k) {
      const Pose truth = {tracker.inside(1), tracker.orientation()};
      const RigidFit fit = fit_rigid(touch(tracker, truth, places, fastrak_noise));
      for (std::size_t t = 0; t < targets.size(); ++t) {
        squares[t] += (fit.room_device * (truth.inverse() * targets[t]) - targets[t]).squaredNorm();
        theory[t] = fit.expected_error(targets[t], fastrak_noise);
      }
      fre += fit.fre * fit.fre;
      fle += fit.fle * fit.fle;
    }
    for (std::size_t t = 0; t < targets.size(); ++t) {
      EXPECT_LE(rms(squares[t], trials), 1.1 * theory[t]) << count << " points, target " << t;
      EXPECT_GE(rms(squares[t], trials), theory[t] / 1.1) << count << " points, target " << t;
    }
    EXPECT_NEAR(rms(fle, trials), fastrak_noise, 0.05 * fastrak_noise)
        << "the error is found from the residual";
    EXPECT_NEAR(rms(fre, trials), std::sqrt(1 - 2.0 / count) * fastrak_noise, 0.05 * fastrak_noise);
    std::cout << fmt::format("{} points: true error at the corner {:.3f} mm, in theory {:.3f} mm\n", count,
                             1e3 * rms(squares[0], trials), 1e3 * theory[0]);
  }
}

void expect_refusal(std::span<const TouchedPoint> points, const char* says) {
  try {
    (void)fit_rigid(points);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
  }
}

TEST(RigidFit, RefusesTooFewPointsAndLines) {
  SimulatedTracker tracker(2);
  std::vector<Vec3> places = {{0, 0, 0}, {0.3, 0, 0}};
  expect_refusal(touch(tracker, {}, places, fastrak_noise), "at least 3");
  expect_refusal({}, "at least 3");
  places.push_back({0.6, 0, 0});
  places.push_back({0.9, 0.01, 0});
  expect_refusal(touch(tracker, {}, places, fastrak_noise), "one line");
  places = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  expect_refusal(touch(tracker, {}, places, 0), "one line");
}

}  // namespace
}  // namespace prosector
