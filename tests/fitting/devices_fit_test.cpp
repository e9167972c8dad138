// Delay, rest, glove and eyes, on simulated devices whose truth is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "common/error.h"
#include "common/hand.h"
#include "drivers/fitting/delay_fit.h"
#include "drivers/fitting/eye_fit.h"
#include "drivers/fitting/glove_fit.h"
#include "drivers/fitting/rest_fit.h"
#include "drivers/gloves/glove_hand.h"
#include "tests/fitting/simulated_tracker.h"

namespace prosector {
namespace {

/// A hand that moves unevenly, m.
double waved(double t) {
  return 0.1 * std::sin(2 * t) + 0.06 * std::sin(5.3 * t + 1) +
         0.03 * std::sin(11.7 * t * (1 + 0.05 * std::sin(0.7 * t)));
}

std::vector<TimedValue> told(SimulatedTracker& tracker, double rate, double late, double noise,
                             double seconds = 10) {
  std::vector<TimedValue> out;
  for (double t = 0; t < seconds; t += 1 / rate) {
    const double jitter = tracker.uniform(0, 0.2 / rate);
    out.push_back(
        {static_cast<std::int64_t>(1e9 * (t + jitter + late)), waved(t + jitter) + noise * tracker.normal()});
  }
  return out;
}

TEST(DelayFit, IsFoundWithinTwoMilliseconds) {
  for (const double delay : {0.0, 3.75e-3, 0.0211, 0.0873, -0.05}) {
    double worst = 0, squares = 0, expected = 0;
    constexpr int trials = 40;
    for (int k = 0; k < trials; ++k) {
      SimulatedTracker tracker(static_cast<unsigned>(k));
      const auto early = told(tracker, 120, 0, 0),
                 late = told(tracker, 60, delay, fastrak_noise / std::sqrt(3.0));
      const DelayFit fit = fit_delay(early, late);
      const double off = fit.delay - delay;
      worst = std::max(worst, std::abs(off));
      squares += off * off / trials;
      expected += fit.error * fit.error / trials;
    }
    std::cout << fmt::format("delay {:6.2f} ms: off by {:.3f} ms RMS, {:.3f} at most, told {:.3f}\n",
                             1e3 * delay, 1e3 * std::sqrt(squares), 1e3 * worst, 1e3 * std::sqrt(expected));
    EXPECT_LT(worst, 2e-3);
    EXPECT_LT(std::sqrt(squares), 3 * std::sqrt(expected)) << "told too small";
    EXPECT_GT(std::sqrt(squares), std::sqrt(expected) / 5) << "told too large";
  }
}

template <class Act>
void expect_input_error(const Act& act, const char* says) {
  try {
    act();
    ADD_FAILURE() << "accepted, not: " << says;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
  }
}

TEST(DelayFit, RefusesWhatTellsNoDelay) {
  SimulatedTracker tracker(1);
  const auto wave = told(tracker, 120, 0, 0);
  expect_input_error([&] { (void)fit_delay(wave, {}); }, "sent no data");
  expect_input_error([&] { (void)fit_delay(wave, told(tracker, 120, 0, 0, 2)); }, "are needed");
  std::vector<TimedValue> still = wave, sine = wave;
  for (TimedValue& v : still) v.value = tracker.normal();
  expect_input_error([&] { (void)fit_delay(wave, still); }, "same motion");
  for (TimedValue& v : sine) v.value = std::sin(2 * std::numbers::pi * 4e-9 * static_cast<double>(v.time_ns));
  expect_input_error([&] { (void)fit_delay(sine, sine); }, "is periodic");
}

std::vector<TimedPose> rest(SimulatedTracker& tracker, const Vec3& drift, double seconds) {
  std::vector<TimedPose> out;
  const Quat q = tracker.orientation();
  for (int i = 0; i < 120 * seconds; ++i)
    out.push_back({static_cast<std::int64_t>(i * 1e9 / 120),
                   tracker.read({Vec3(0.1, 0.2, 0.3) + i / 120.0 * drift, q})});
  return out;
}

TEST(RestFit, FindsNoiseAndDrift) {
  SimulatedTracker tracker(4);
  const RestFit fit = fit_rest(rest(tracker, Vec3(0, 2e-3, 0) / 60, 60));
  EXPECT_NEAR(fit.noise, fastrak_noise, 0.05 * fastrak_noise);
  EXPECT_NEAR(fit.turn_noise, fastrak_turn_noise, 0.05 * fastrak_turn_noise);
  EXPECT_NEAR(fit.drift, 2e-3, 4 * fit.drift_error);
  EXPECT_LT(fit.drift_error, 0.1e-3);
  EXPECT_NEAR(fit.rate, 120, 1);
  expect_input_error([&] { (void)fit_rest({}); }, "are needed");
  std::vector<TimedPose> moved = rest(tracker, Vec3::Zero(), 5);
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i].pose.p.x() += i % 200 < 100 ? 0 : 0.1;
  expect_input_error([&] { (void)fit_rest(moved); }, "moved");
}

/// A glove with its own counts for each finger, and a wearer who makes no pose twice alike.
struct SimulatedGlove {
  SimulatedTracker& tracker;
  GloveCounts open, closed;
  double noise;
  double repeat;  // flexion RMS

  std::array<std::uint16_t, fingers> read(const std::array<double, fingers>& flexion) {
    std::array<std::uint16_t, fingers> out{};
    for (std::size_t i = 0; i < fingers; ++i)
      out[i] = static_cast<std::uint16_t>(std::clamp(
          std::round(open[i] + flexion[i] * (closed[i] - open[i]) + noise * tracker.normal()), 0.0, 4095.0));
    return out;
  }
  std::vector<PoseCounts> hold_all() {
    std::vector<PoseCounts> out;
    for (const GlovePose& pose : glove_poses()) {
      std::array<double, fingers> flexion{};
      for (std::size_t i = 0; i < fingers; ++i)
        flexion[i] = (pose.bent[i] ? 1 : 0) + repeat * tracker.normal();
      std::vector<std::array<std::uint16_t, fingers>> readings;
      for (int k = 0; k < 60; ++k) readings.push_back(read(flexion));
      out.push_back(pose_counts(readings));
    }
    return out;
  }
};

TEST(GloveFit, JointsAreWithinThreeDegrees) {
  for (const bool falls : {false, true}) {
    double squares = 0, expected = 0;
    int judged = 0;
    constexpr int trials = 50;
    for (unsigned k = 0; k < trials; ++k) {
      SimulatedTracker tracker(k);
      SimulatedGlove glove{tracker, {}, {}, 3, 0.015};
      for (std::size_t i = 0; i < fingers; ++i) {
        glove.open[i] = tracker.uniform(750, 900);
        glove.closed[i] = glove.open[i] + tracker.uniform(350, 600);
        if (falls) std::swap(glove.open[i], glove.closed[i]);
      }
      const GloveFit fit = fit_glove(glove.hold_all(), 50);
      EXPECT_EQ(fit.falls_on_bending, falls);
      EXPECT_TRUE(fit.doubts.empty());
      GloveConfig glove_config;
      glove_config.calibration = fit.calibration;
      FlexionCalibrator calibrator(glove_config, 40);
      for (int pose = 0; pose < 40; ++pose) {
        std::array<double, fingers> flexion{};
        for (double& x : flexion) x = tracker.uniform(0, 1);
        const std::array<std::uint16_t, fingers> counts = glove.read(flexion);
        GloveCounts read{};
        std::copy(counts.begin(), counts.end(), read.begin());
        const auto truth = joint_angles(flexion), told = joint_angles(calibrator.update(read));
        for (std::size_t j = 0; j < hand_joints; ++j, ++judged) squares += std::pow(told[j] - truth[j], 2);
      }
      for (const double e : fit.joint_error) expected += e * e / fingers / trials;
    }
    const double rms = std::sqrt(squares / judged);
    std::cout << fmt::format("joints off by {:.2f}° RMS, told {:.2f}°\n", rms / degree,
                             std::sqrt(expected) / degree);
    EXPECT_LE(rms, 3 * degree);
    EXPECT_LE(rms, std::sqrt(expected)) << "no worse than told";
    EXPECT_GE(rms, std::sqrt(expected) / 4);
  }
}

TEST(GloveFit, NamesTheFingerThatDidNotBendAndSwappedSensors) {
  SimulatedTracker tracker(3);
  SimulatedGlove glove{tracker, {800, 800, 800, 800, 800}, {1300, 1300, 1300, 830, 1300}, 3, 0.01};
  expect_input_error([&] { (void)fit_glove(glove.hold_all(), 50); }, "ring finger");
  glove.closed[3] = 1300;
  std::vector<PoseCounts> swapped = glove.hold_all();
  std::swap(swapped[2], swapped[6]);  // a left glove on a right hand
  const GloveFit fit = fit_glove(swapped, 50);
  ASSERT_FALSE(fit.doubts.empty());
  EXPECT_NE(fit.doubts[0].find("thumb"), std::string::npos);
}

/// An eye's camera with known truth: off-axis, of 800 × 600 pixels.
struct SimulatedEye {
  Pose eye;
  double half_wide, half_high, shift;

  Eigen::Vector2d see(const Vec3& point) const {
    const Vec3 x = eye.inverse() * point;
    const double u = -x.x() / x.z(), v = -x.y() / x.z();
    return {800 * (u - shift + half_wide) / (2 * half_wide), 600 * (half_high - v) / (2 * half_high)};
  }
};

std::vector<SeenPoint> look(SimulatedTracker& tracker, const SimulatedEye& eye, int count, double pixels) {
  std::vector<SeenPoint> out;
  while (static_cast<int>(out.size()) < count) {
    const Vec3 p =
        eye.eye * Vec3(tracker.uniform(-0.3, 0.3), tracker.uniform(-0.25, 0.25), tracker.uniform(-1.2, -0.4));
    const Eigen::Vector2d at = eye.see(p);
    if (at.x() < 0 || at.y() < 0 || at.x() > 800 || at.y() > 600) continue;
    out.push_back({p, at + pixels * Eigen::Vector2d(tracker.normal(), tracker.normal())});
  }
  return out;
}

TEST(EyeFit, SpaamFindsBothEyesAndTheDisplay) {
  SimulatedTracker tracker(5);
  const Pose head = {Vec3(0.02, -0.08, -0.05), Quat(Eigen::AngleAxisd(0.2, Vec3(1, 0.3, 0.1).normalized()))};
  const double half_wide = std::tan(20 * degree), half_high = std::tan(15.5 * degree), apart = 0.0634;
  const double shift = apart / 2 / 0.6;  // pictures coincide at 0.6 m
  const SimulatedEye left{{head * Vec3(-apart / 2, 0, 0), head.q}, half_wide, half_high, shift};
  const SimulatedEye right{{head * Vec3(apart / 2, 0, 0), head.q}, half_wide, half_high, -shift};
  const EyesFit exact = join_eyes(fit_eye(look(tracker, left, 12, 0), 800, 600),
                                  fit_eye(look(tracker, right, 12, 0), 800, 600));
  EXPECT_NEAR(exact.distance, apart, 1e-7);
  EXPECT_NEAR(exact.fov_horizontal, 40 * degree, 1e-7);
  EXPECT_NEAR(exact.fov_vertical, 31 * degree, 1e-7);
  EXPECT_NEAR(exact.convergence, 0.6, 1e-5);
  EXPECT_LT((exact.head.p - head.p).norm(), 1e-7);
  EXPECT_LT(exact.head.q.angularDistance(head.q), 1e-6);

  const EyeFit noisy = fit_eye(look(tracker, left, 20, 1), 800, 600);
  EXPECT_LT(noisy.residual, 2);
  EXPECT_GT(noisy.residual, 0.5);
  // Points that were not fitted are drawn where they are seen.
  double squares = 0;
  for (const SeenPoint& s : look(tracker, left, 200, 0))
    squares += ((noisy.projection * s.point.homogeneous()).hnormalized() - s.pixel).squaredNorm() / 200;
  EXPECT_LT(std::sqrt(squares), 3) << "pixels";
  expect_input_error([&] { (void)fit_eye(look(tracker, left, 11, 0), 800, 600); }, "at least 12");
  std::vector<SeenPoint> flat;
  for (int i = 0; i < 20; ++i) {
    const Vec3 p = left.eye * Vec3(tracker.uniform(-0.2, 0.2), tracker.uniform(-0.15, 0.15), -0.8);
    flat.push_back({p, left.see(p)});
  }
  expect_input_error([&] { (void)fit_eye(flat, 800, 600); }, "one plane");
}

TEST(EyeFit, OnePixelOffIsAFewMillimetres) {
  SimulatedTracker tracker(7);
  const double half_wide = std::tan(20 * degree), half_high = std::tan(15.5 * degree), apart = 0.0634;
  const SimulatedEye left{{Vec3(-apart / 2, 0, 0), Quat::Identity()}, half_wide, half_high, apart / 1.2};
  const SimulatedEye right{{Vec3(apart / 2, 0, 0), Quat::Identity()}, half_wide, half_high, -apart / 1.2};
  for (const int count : {12, 16, 20}) {
    double distance = 0, fov = 0;
    constexpr int trials = 300;
    for (int k = 0; k < trials; ++k) {
      const EyesFit eyes = join_eyes(fit_eye(look(tracker, left, count, 1), 800, 600),
                                     fit_eye(look(tracker, right, count, 1), 800, 600));
      distance += std::pow(eyes.distance - apart, 2) / trials;
      fov += std::pow(eyes.fov_horizontal - 40 * degree, 2) / trials;
    }
    std::cout << fmt::format(
        "{} points an eye, 1 pixel off: distance within {:.2f} mm RMS, field of view {:.2f}°\n", count,
        1e3 * std::sqrt(distance), std::sqrt(fov) / degree);
    EXPECT_LT(std::sqrt(distance), 6e-3);
    EXPECT_LT(std::sqrt(fov), 2 * degree);
  }
}

TEST(EyeFit, TheSightGivesTheDistanceAndRefusesNonsense) {
  // Eyes 64 mm apart, the rod at 0.4 m, the screen at 0.7 m: the marks are 48 mm apart.
  const EyeDistance fit = eye_distance_by_sighting(0.048, 0.7, 0.4);
  EXPECT_NEAR(fit.distance, 0.064, 1e-12);
  SimulatedTracker tracker(6);
  double squares = 0;
  constexpr int trials = 20000;
  for (int k = 0; k < trials; ++k) {
    const double off = eye_distance_by_sighting(0.048 + 1e-3 * tracker.normal(),
                                                0.7 + 5e-3 * tracker.normal(), 0.4 + 5e-3 * tracker.normal())
                           .distance -
                       0.064;
    squares += off * off / trials;
  }
  EXPECT_NEAR(std::sqrt(squares), fit.error, 0.05 * fit.error);
  expect_input_error([] { (void)eye_distance_by_sighting(0.01, 0.7, 0.4); }, "between the eyes");
  EXPECT_DOUBLE_EQ(pixel_size_from_card(342.4), 0.25e-3);
  expect_input_error([] { (void)pixel_size_from_card(0); }, "any screen");
  expect_input_error([] { (void)eye_distance_by_sighting(0.05, 0.4, 0.7); },
                     "between the eyes and the screen");
}

}  // namespace
}  // namespace prosector
