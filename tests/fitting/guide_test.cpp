// Guides as a window uses them: samples of simulated devices in, steps and outcomes out.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "common/error.h"
#include "drivers/device/pose_chain.h"
#include "drivers/fitting/eyes_guide.h"
#include "drivers/fitting/field_guide.h"
#include "drivers/fitting/glove_guide.h"
#include "drivers/fitting/phantom_guide.h"
#include "drivers/fitting/room_guide.h"
#include "drivers/fitting/timed_guides.h"
#include "drivers/fitting/tip_guide.h"
#include "tests/fitting/simulated_tracker.h"
#include "twins/trackers/distorted_field.h"

namespace prosector {
namespace {

/// A receiver at 120 Hz whose samples go to a guide.
struct FedGuide {
  Guide& guide;
  SimulatedTracker& tracker;
  std::uint32_t station = 0;
  std::int64_t time_ns = 0;
  Pose at;

  void feed(const Pose& pose) {
    DeviceSample sample;
    sample.station = station;
    sample.time_ns = time_ns += 8'333'333;
    sample.has_pose = true;
    sample.pose = tracker.read(pose);
    guide.take(sample);
  }
  void hold(const Pose& pose, double seconds) {
    for (int i = 0; i < 120 * seconds; ++i) feed(pose);
    at = pose;
  }
  void go(const Pose& pose, double seconds = 0.4) {
    const Pose from = at;
    const int steps = static_cast<int>(120 * seconds);
    for (int i = 0; i < steps; ++i) {
      const double u = static_cast<double>(i) / steps;
      feed({from.p + u * (pose.p - from.p), from.q.slerp(u, pose.q)});
    }
    at = pose;
  }
};

ConfigValue change_of(const GuideOutcome& outcome, const std::string& key) {
  for (const ConfigChange& change : outcome.changes)
    if (change.key == key) return change.value;
  throw std::runtime_error("no change of " + key);
}

const std::vector<Vec3> corners = {{-0.2, 0.8, 0}, {0.2, 0.8, 0}, {0.2, 0.8, -0.3}, {-0.2, 1.1, -0.3}};

TEST(RoomGuide, LeadsFromPointToPointAndRefusesWrongOnes) {
  SimulatedTracker tracker(1);
  const Pose truth = {Vec3(0.5, 0.9, 0.2), tracker.orientation()};
  RoomGuide guide(ClientConfig(), StationRole::right_hand, corners);
  FedGuide fed{guide, tracker, 0, 0, {truth.inverse() * Vec3(0, 0, 0), Quat::Identity()}};
  const auto place = [&](const Vec3& p) { return Pose{truth.inverse() * p, Quat::Identity()}; };
  fed.hold(fed.at, 3);  // what lies on the table touches nothing
  EXPECT_EQ(guide.step().index, 0u);
  EXPECT_EQ(*guide.step().target, corners[0]);
  EXPECT_THROW((void)guide.outcome(), InputError);
  fed.go(place(corners[0]));
  fed.hold(place(corners[0]), 5);  // however long: once
  EXPECT_EQ(guide.step().index, 1u);
  const Vec3 wrong(0, 0.9, -0.1);
  fed.go(place(wrong));
  fed.hold(place(wrong), 1);
  EXPECT_EQ(guide.step().index, 1u);
  EXPECT_NE(guide.step().rejection.find("should be 400 mm"), std::string::npos) << guide.step().rejection;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    fed.go(place(corners[i]));
    fed.hold(place(corners[i]), 1);
    EXPECT_EQ(guide.step().index, i + 1);
    EXPECT_TRUE(guide.step().rejection.empty());
  }
  EXPECT_TRUE(guide.step().done);
  EXPECT_LT((guide.fit().room_device.p - truth.p).norm(), 1e-3);
  const auto p = std::get<std::vector<double>>(change_of(guide.outcome(), "tracker.room.position"));
  EXPECT_LT((Vec3(p.data()) - guide.fit().room_device.p).norm(), 1e-6);
}

TEST(RoomGuide, GoesBackWhereThePointBeforeWasWrong) {
  SimulatedTracker tracker(8);
  RoomGuide guide(ClientConfig(), StationRole::right_hand, corners);
  FedGuide fed{guide, tracker, 0, 0, {Vec3(0, 0.5, 0.2), Quat::Identity()}};
  const auto touch = [&](const Vec3& p) {
    fed.go({p, Quat::Identity()});
    fed.hold(fed.at, 1);
  };
  touch(corners[0]);
  touch(corners[0] + Vec3(0, 0.4, 0));  // as far as point 2 is
  EXPECT_EQ(guide.step().index, 2u);
  touch(corners[2]);
  EXPECT_EQ(guide.step().index, 2u);
  touch(corners[2] + Vec3(0.05, 0, 0));
  EXPECT_EQ(guide.step().index, 1u) << "point 2 is asked for again";
  EXPECT_NE(guide.step().rejection.find("touch point 2 again"), std::string::npos) << guide.step().rejection;
  for (std::size_t i = 1; i < corners.size(); ++i) touch(corners[i]);
  EXPECT_TRUE(guide.step().done);
  guide.back();
  EXPECT_EQ(guide.step().index, corners.size() - 1);
}

TEST(RoomGuide, TellsAWrongHemisphere) {
  SimulatedTracker tracker(10);
  RoomGuide guide(ClientConfig(), StationRole::right_hand, corners);
  FedGuide fed{guide, tracker, 0, 0, {Vec3(0, -0.5, 0.2), Quat::Identity()}};
  for (const Vec3& p : corners) {
    fed.go({-p, Quat::Identity()});
    fed.hold(fed.at, 1);
  }
  ASSERT_TRUE(guide.step().done);
  try {
    (void)guide.outcome();
    ADD_FAILURE() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("hemisphere"), std::string::npos) << e.what();
  }
}

TEST(RoomGuide, RefusesPointsThatGiveNoPose) {
  const std::vector<Vec3> line = {{0, 0, 0}, {0.3, 0, 0}, {0.6, 0, 0}};
  EXPECT_THROW(RoomGuide(ClientConfig(), StationRole::right_hand, line), InputError);
  EXPECT_THROW(RoomGuide(ClientConfig(), StationRole::right_hand, {}), InputError);
  EXPECT_THROW(RoomGuide(ClientConfig(), StationRole::instrument, corners), InputError)
      << "no receiver has that role";
}

/// Touches points of a phantom, which stands in the room, or shows the camera its board.
TEST(PhantomGuide, FindsTheShapeAndTellsTheErrorAtTargets) {
  const std::vector<Vec3> points = {
      {-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1}, {-0.1, 0, -0.1}, {0, 0.15, 0}};
  const std::vector<Vec3> targets = {{0, 0.05, 0}, {0.3, 0.3, 0}};
  std::array<double, 2> squares{}, told{};
  constexpr int tries = 40;
  for (unsigned seed = 0; seed < tries; ++seed) {
    SimulatedTracker tracker(seed);
    const Pose truth = {Vec3(0.2, 0.9, -0.1), tracker.orientation()};
    ClientConfig config;
    config.phantom.mesh = "x.stl";
    PhantomGuide guide(config, StationRole::right_hand, points, targets);
    FedGuide fed{guide, tracker, 0, 0, {truth * Vec3(0, 0.4, 0.3), Quat::Identity()}};
    for (const Vec3& p : points) {
      const Vec3 slip = tracker.noise(1e-3);
      fed.go({truth * p + slip, Quat::Identity()});
      fed.hold(fed.at, 1);
    }
    ASSERT_TRUE(guide.step().done) << guide.step().rejection;
    const GuideOutcome outcome = guide.outcome();
    ASSERT_EQ(outcome.words.size(), 1 + targets.size());
    const ClientConfig written = parse_client_config(
        write_client_config("[phantom]\nmesh = 'x.stl'\n", outcome.changes, "c.toml"), "c.toml");
    for (std::size_t k = 0; k < targets.size(); ++k) {
      squares[k] += (*written.phantom.pose * targets[k] - truth * targets[k]).squaredNorm();
      told[k] += std::pow(guide.fit().expected_error(targets[k]), 2);
    }
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const double rms = std::sqrt(squares[k] / tries);
    std::cout << "target " << k + 1 << ": " << 1e3 * rms << " mm RMS, told "
              << 1e3 * std::sqrt(told[k] / tries) << '\n';
    EXPECT_LT(rms, k == 0 ? 1e-3 : 3e-3) << "m";
    EXPECT_NEAR(std::sqrt(told[k] / tries) / rms, 1, 0.35);
  }
}

TEST(PhantomGuide, WantsACameraForAPhantomsBoard) {
  ClientConfig config;
  config.phantom.board = "table";
  for (const char* tracker : {"fastrak:/dev/ttyS0", "face:0"}) {
    config.tracker = tracker;
    EXPECT_THROW((void)PhantomGuide::device(config), InputError) << tracker;
  }
  config.tracker = "hands:0,2";
  EXPECT_EQ(PhantomGuide::device(config).camera.table, "table");
  config.tracker = "tags:0";
  config.tracker_device.camera.table = "tablet";
  EXPECT_EQ(PhantomGuide::device(config).camera.table, "table");
  EXPECT_TRUE(PhantomGuide::device(config).camera.room_table.p.isZero());
  config.phantom.board.clear();
  EXPECT_EQ(PhantomGuide::device(config).camera.table, "tablet");
  const std::vector<Vec3> points = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
  EXPECT_THROW(PhantomGuide(config, StationRole::right_hand, points, {}), InputError) << "has no shape";
}

// A camera tells a fifth of what a tracker does in the same time.
TEST(StillnessDetector, IsStillAfterEnoughReadingsHoweverSeldomTheyCome) {
  for (const double rate : {8., 15., 30., 120.}) {
    SimulatedTracker tracker(11);
    StillnessDetector window;
    std::int64_t time_ns = 0;
    const auto take = [&](const Vec3& place) {
      window.take(time_ns += static_cast<std::int64_t>(1e9 / rate),
                  tracker.read({place, Quat::Identity()}, 3e-4));
    };
    for (int k = 0; k < 100; ++k) {
      take(Vec3(0.2 / rate * k, 0, 0));
      EXPECT_FALSE(window.still()) << rate << " Hz: it moves by 0.2 m/s";
    }
    const Vec3 rest(0.2 / rate * 99, 0, 0);
    int readings = 0;
    for (; !window.still() && readings < 200; ++readings) take(rest);
    EXPECT_LE(readings, std::max(0.5 * rate, 20.) + 2) << rate << " Hz";
    EXPECT_LT((window.mean().p - rest).norm(), 1e-3);
  }
}

TEST(TipGuide, WaitsForTheTipAndEndsWithIt) {
  SimulatedTracker tracker(2);
  const Vec3 tip(0, 0.01, -0.12), pivot(0.2, 0.1, -0.3);
  const auto about = [&](const Quat& q) { return Pose{pivot - q * tip, q}; };
  TipGuide guide(ClientConfig(), StationRole::right_hand);
  FedGuide fed{guide, tracker, 0, 0, {Vec3(0, 0, 0), Quat::Identity()}};
  fed.go(about(Quat::Identity()), 1);
  EXPECT_EQ(guide.step().index, 0u) << "it moves yet";
  fed.hold(fed.at, 1);
  EXPECT_EQ(guide.step().index, 1u);
  for (int k = 0; k < 200 && !guide.step().done; ++k) {
    const double a = 2.4 * k;
    const Pose to = about(Quat(Eigen::AngleAxisd(0.6, Vec3(std::cos(a), std::sin(a), 0))));
    const Quat from = fed.at.q;
    for (int i = 0; i < 40; ++i) fed.feed(about(from.slerp(i / 40.0, to.q)));
    fed.at = to;
  }
  ASSERT_TRUE(guide.step().done);
  EXPECT_LT((guide.fit().tip - tip).norm(), 0.5e-3);
  const GuideOutcome outcome = guide.outcome();
  EXPECT_EQ(std::get<double>(change_of(outcome, "tracker.stations.right.station")), 1);
  const std::string text =
      write_client_config("[tracker]\naddress = 'fastrak:/x'\n", outcome.changes, "c.toml");
  EXPECT_LT((parse_client_config(text, "c.toml").tracker_device.placement.mount[0].p - tip).norm(), 0.5e-3);
}

// The whole way of a bent field: guide, fit, file, driver's chain.
TEST(FieldGuide, ItsMapPutsTheDriversPosesRight) {
  SimulatedTracker tracker(3);
  DistortedField field;
  field.metal = {0.85, 0.2, -0.8};
  field.shift = 20e-3;
  field.turn = 0.03;
  ClientConfig config;
  config.tracker_device.placement.room_device = {Vec3(0, 0.9, 0.4),
                                                 Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
  const Pose& room = config.tracker_device.placement.room_device;
  const Quat held(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
  FieldGuide guide(config, StationRole::right_hand,
                   {Vec3(-0.2, 0.7, -0.5), Vec3(0.2, 1.1, -0.1), {4, 4, 4}, held}, "f.toml");
  const auto reported = [&](const Pose& truth) { return field.report(room.inverse() * truth); };
  FedGuide fed{guide, tracker, 0, 0, reported({Vec3(0.4, 0.6, 0.1), held})};
  fed.hold(fed.at, 1);
  while (!guide.step().done) {
    const std::size_t before = guide.step().index;
    const Pose place = reported({*guide.step().target, held});
    fed.go(place, 0.2);
    fed.hold(place, 0.6);
    ASSERT_EQ(guide.step().index, before + 1) << guide.step().rejection;
  }
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("prosector-field-{}.toml", getpid());
  save_config_text(file, write_field_map(guide.fit().map));
  const PoseChain without(config.tracker_device.placement);
  config.tracker_device.placement.field_map = file.string();
  const PoseChain with(config.tracker_device.placement);
  std::filesystem::remove(file);
  double before = 0, after = 0, turned = 0;
  for (int k = 0; k < 500; ++k) {
    const Pose truth = {Vec3(0, 0.9, -0.3) + tracker.inside(0.2), tracker.orientation()};
    before += (without.room(reported(truth), 0).p - truth.p).squaredNorm() / 500;
    after += (with.room(reported(truth), 0).p - truth.p).squaredNorm() / 500;
    turned = std::max(turned, with.room(reported(truth), 0).q.angularDistance(truth.q));
  }
  EXPECT_GT(std::sqrt(before), 2e-3);
  EXPECT_LT(std::sqrt(after), 0.3 * std::sqrt(before));
  EXPECT_LT(turned, 1 * degree);
  EXPECT_EQ(std::get<std::string>(change_of(guide.outcome(), "tracker.field_map")), "f.toml");
}

TEST(FieldGuide, TakesNoPlaceThatIsFarFromItsPoint) {
  SimulatedTracker tracker(4);
  FieldGuide guide(ClientConfig(), StationRole::right_hand,
                   {Vec3(0, 0, 0), Vec3(0.4, 0.4, 0.4), {3, 3, 3}, {}}, "f.toml");
  FedGuide fed{guide, tracker, 0, 0, {Vec3(1, 1, 1), Quat::Identity()}};
  fed.go({Vec3(0.4, 0.4, 0.4), Quat::Identity()});
  fed.hold(fed.at, 1);
  EXPECT_EQ(guide.step().index, 0u);
  EXPECT_NE(guide.step().rejection.find("mm from the instructed position"), std::string::npos);
}

TEST(GloveGuide, TakesEachPoseOnceAndFindsTheCounts) {
  SimulatedTracker tracker(5);
  GloveGuide guide(right_hand, 50);
  std::int64_t time_ns = 0;
  std::array<double, fingers> at{};
  const auto feed = [&](const std::array<double, fingers>& flexion) {
    DeviceSample sample;
    sample.has_flexion = true;
    sample.time_ns = time_ns += 10'000'000;
    for (std::size_t i = 0; i < fingers; ++i)
      sample.raw_flexion[i] =
          static_cast<std::uint16_t>(std::lround(1300 - 500 * flexion[i] + 3 * tracker.normal()));
    guide.take(sample);
  };
  for (const GlovePose& pose : glove_poses()) {
    EXPECT_EQ(guide.step().instruction, pose.instruction);
    std::array<double, fingers> to{};
    for (std::size_t i = 0; i < fingers; ++i) to[i] = pose.bent[i] ? 1 : 0;
    for (int k = 0; k < 40; ++k) {
      std::array<double, fingers> between{};
      for (std::size_t i = 0; i < fingers; ++i) between[i] = at[i] + k / 40.0 * (to[i] - at[i]);
      feed(between);
    }
    for (int k = 0; k < 300; ++k) feed(to);
    at = to;
  }
  ASSERT_TRUE(guide.step().done);
  const GloveFit fit = guide.fit();
  EXPECT_TRUE(fit.falls_on_bending);
  for (std::size_t i = 0; i < fingers; ++i) {
    EXPECT_NEAR(fit.calibration.open[i], 1300, 2);
    EXPECT_NEAR(fit.calibration.closed[i], 800, 2);
    EXPECT_LT(fit.joint_error[i], 3 * degree);
  }
  EXPECT_TRUE(std::get<bool>(change_of(guide.outcome(), "glove.right.falls_on_bending")));
}

// Both eyes through a display with known truth: what comes out is read back by the configuration.
TEST(EyesGuide, FindsDisplayEyesAndMount) {
  SimulatedTracker tracker(9);
  ClientConfig config =
      parse_client_config("[tracker]\naddress = 'fastrak:/x'\nstations.head.station = 2\n", "c.toml");
  const Vec3 mark(0.1, 1.2, -1.5);
  const Pose mount = {Vec3(0.01, -0.09, -0.06), Quat(Eigen::AngleAxisd(0.15, Vec3(1, 0.2, 0).normalized()))};
  constexpr double apart = 0.066;
  const double half_wide = std::tan(20 * degree), half_high = std::tan(15.5 * degree),
               shift = apart / 2 / 0.8;
  EyesGuide guide(config, mark, 800, 600);
  FedGuide fed{guide, tracker, 1, 0, {}};
  EXPECT_FALSE(guide.confirm());
  EXPECT_NE(guide.step().rejection.find("still"), std::string::npos);
  while (!guide.step().done) {
    const std::size_t before = guide.step().index;
    const bool right = before >= guide.step().count / 2;
    const Eigen::Vector2d cross = *guide.step().pixel;
    // Where the mark is in the eye's frame, so that the cross lies over it.
    const double far = before % 2 == 0 ? 0.6 : 2,
                 u = (2 * cross.x() / 800 - 1) * half_wide + (right ? -shift : shift),
                 v = (1 - 2 * cross.y() / 600) * half_high;
    const Vec3 in_eye(far * u, far * v, -far);
    const Vec3 in_head = Vec3((right ? 0.5 : -0.5) * apart, 0, 0) + in_eye;
    const Quat turn = tracker.orientation();
    const Pose receiver = {mark - turn * (mount * in_head), turn};
    for (int i = 0; i < 60; ++i) {
      DeviceSample sample;
      sample.station = 1;
      sample.has_pose = true;
      sample.time_ns = fed.time_ns += 8'333'333;
      sample.pose = tracker.read(receiver, 2e-4, 1e-4);
      guide.take(sample);
    }
    ASSERT_TRUE(guide.confirm());
    EXPECT_FALSE(guide.confirm()) << "a cross isn't where the last one was";
    EXPECT_EQ(guide.step().index, before + 1);
  }
  EXPECT_FALSE(guide.confirm());
  EXPECT_NE(guide.step().rejection.find("all crosses"), std::string::npos) << guide.step().rejection;
  const std::string text = write_client_config(
      "[tracker]\naddress = 'fastrak:/x'\nstations.head.station = 2\n", guide.outcome().changes, "c.toml");
  const ClientConfig read = parse_client_config(text, "c.toml");
  EXPECT_NEAR(*read.eyes.distance, apart, 1e-3);
  EXPECT_NEAR(*read.eyes.fov_horizontal, 40 * degree, 0.3 * degree);
  EXPECT_NEAR(*read.eyes.fov_vertical, 31 * degree, 0.3 * degree);
  EXPECT_NEAR(*read.eyes.convergence, 0.8, 0.1);
  EXPECT_LT((read.tracker_device.placement.mount[1].p - mount.p).norm(), 2e-3);
  EXPECT_LT(read.tracker_device.placement.mount[1].q.angularDistance(mount.q), 0.3 * degree);
  guide.back();
  EXPECT_FALSE(guide.step().done);
  EXPECT_EQ(guide.step().rejection, "") << "a cross is to be confirmed again";
}

TEST(DelayGuide, ComparesDevicesOfOtherFramesAndUnits) {
  SimulatedTracker tracker(6);
  DelayGuide guide(0, 6);
  const Quat other = tracker.orientation();
  for (int i = 0; !guide.step().done; ++i) {
    const double t = i / 120.0;
    const Vec3 p(0.1 * std::sin(2 * t) + 0.05 * std::sin(7.3 * t), 0.08 * std::cos(3.1 * t),
                 0.03 * std::sin(11 * t));
    guide.add_other_position(static_cast<std::int64_t>(1e9 * t), 100 * (other * p) + Vec3(50, 0, 0));
    DeviceSample sample;
    sample.has_pose = true;
    sample.time_ns = static_cast<std::int64_t>(1e9 * (t + 0.031));
    sample.pose = tracker.read({p, Quat::Identity()});
    guide.take(sample);
  }
  EXPECT_NEAR(guide.fit().delay, 0.031, 2e-3);
}

}  // namespace
}  // namespace prosector
