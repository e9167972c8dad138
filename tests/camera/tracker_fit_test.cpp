#include "drivers/camera/calibration/tracker_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "common/error.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double mm = 1e-3;
constexpr unsigned seeds = 40;

/// Returns a vector of normal numbers whose length is so long, RMS.
Vec3 noise_of(Random& random, double rms) {
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += random.uniform(0, 1);
    out[axis] = sum * rms / std::sqrt(3.0);
  }
  return out;
}

Pose disturbed(Random& random, const Pose& pose, double place, double turn) {
  return {pose.p + noise_of(random, place), (rotated_by(noise_of(random, turn)) * pose.q).normalized()};
}

/// A camera before a tracker, and what both say of a board on a receiver.
struct Room {
  Pose tracker_camera, receiver_board;
  std::vector<TrackedPair> pairs;
};

struct RoomCase {
  std::size_t pairs = 20;
  double place = 0.8 * mm, turn = 0.15 * radians;  // the tracker's noise, RMS of all three axes
  bool one_axis = false;
};

Room room_of(unsigned seed, const RoomCase& what) {
  Random random(seed);
  Room room;
  room.tracker_camera = {random.point(0.5), rotated_by(random.point(1.5))};
  room.receiver_board = {random.point(0.05), rotated_by(random.point(1))};
  for (std::size_t i = 0; i < what.pairs; ++i) {
    const Vec3 tilt(random.uniform(-45, 45), random.uniform(-45, 45), 0);
    const double roll = what.one_axis ? 0 : random.uniform(-120, 120);
    const Vec3 tilted = radians * (what.one_axis ? Vec3(0, tilt.y(), 0) : tilt);
    Pose camera_board;
    camera_board.p = {random.uniform(-0.15, 0.15), random.uniform(-0.1, 0.1), random.uniform(0.45, 0.7)};
    camera_board.q = rotated_by(tilted) * rotated_by({0, 0, radians * roll}) * Quat(0, 1, 0, 0);
    const Pose receiver = room.tracker_camera * camera_board * room.receiver_board.inverse();
    room.pairs.push_back({disturbed(random, receiver, what.place, what.turn),
                          disturbed(random, camera_board, 0.07 * mm, 0.04 * radians)});
  }
  return room;
}

struct RoomErrors {
  std::vector<double> place, turn, told;  // m where boards were; rad; m
};

RoomErrors errors_of(const RoomCase& what) {
  RoomErrors out;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Room room = room_of(seed, what);
    const TrackerFit fit = fit_tracker(room.pairs);
    const Vec3 target = fit.tracker_camera.inverse() * fit.centre;
    out.place.push_back((room.tracker_camera * target - fit.centre).norm());
    out.turn.push_back(fit.tracker_camera.q.angularDistance(room.tracker_camera.q));
    out.told.push_back(fit.expected_error(fit.centre));
  }
  return out;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string complaint_of(const std::vector<TrackedPair>& pairs) {
  try {
    (void)fit_tracker(pairs);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(TrackerFit, TwentyPosesGiveTheCameraToAQuarterOfAMillimetre) {
  const RoomErrors errors = errors_of({});
  RecordProperty("place_um", static_cast<int>(1e6 * mean_of(errors.place)));
  RecordProperty("turn_mdeg", static_cast<int>(1e3 * mean_of(errors.turn) / radians));
  EXPECT_LE(mean_of(errors.place), 0.26 * mm);
  EXPECT_LE(mean_of(errors.turn), 0.05 * radians);
  // What is told is about right.
  EXPECT_NEAR(mean_of(errors.told) / mean_of(errors.place), 1.08, 0.25);
}

TEST(TrackerFit, MorePosesLeaveLessError) {
  double before = 1;
  for (const std::size_t pairs : {10u, 20u, 40u, 80u}) {
    const RoomErrors errors = errors_of({pairs});
    std::cout << pairs << " poses: " << 1e3 * mean_of(errors.place) << " mm, "
              << mean_of(errors.turn) / radians << "°, told " << 1e3 * mean_of(errors.told) << " mm\n";
    EXPECT_LT(mean_of(errors.place), 0.85 * before);
    before = mean_of(errors.place);
  }
}

TEST(TrackerFit, ExactPosesGiveExactFrames) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Room room = room_of(seed, {});
    for (TrackedPair& pair : room.pairs)
      pair.tracker_receiver = room.tracker_camera * pair.camera_board * room.receiver_board.inverse();
    const TrackerFit fit = fit_tracker(room.pairs);
    EXPECT_LT((fit.tracker_camera.p - room.tracker_camera.p).norm(), 1e-8);
    EXPECT_LT((fit.receiver_board.p - room.receiver_board.p).norm(), 1e-8);
    EXPECT_LT(fit.tracker_camera.q.angularDistance(room.tracker_camera.q), 1e-7);
    EXPECT_LT(fit.receiver_board.q.angularDistance(room.receiver_board.q), 1e-7);
    EXPECT_LT(fit.method_difference, 1e-6);
  }
}

TEST(TrackerFit, PosesThatDontBelongAreLeftOut) {
  std::vector<double> place;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    Room room = room_of(seed, {});
    for (const std::size_t i : {3u, 11u, 17u}) room.pairs[i].tracker_receiver.p += Vec3(0.03, -0.02, 0.04);
    const TrackerFit fit = fit_tracker(room.pairs);
    for (const std::size_t i : {3u, 11u, 17u})
      EXPECT_NE(std::find(fit.left_out.begin(), fit.left_out.end(), i), fit.left_out.end()) << seed;
    place.push_back((room.tracker_camera * (fit.tracker_camera.inverse() * fit.centre) - fit.centre).norm());
  }
  EXPECT_LE(mean_of(place), 0.3 * mm);
}

TEST(TrackerFit, SaysWhatToDo) {
  EXPECT_NE(complaint_of({}).find("at least 6 are needed"), std::string::npos);
  EXPECT_NE(complaint_of(room_of(1, {5}).pairs).find("at least 6"), std::string::npos);
  RoomCase still;
  still.one_axis = true;
  EXPECT_NE(complaint_of(room_of(1, still).pairs).find("rotate it about two axes"), std::string::npos);
  Room jumbled = room_of(1, {});
  std::vector<TrackedPair> pairs = jumbled.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs[i].camera_board = jumbled.pairs[(i + 7) % pairs.size()].camera_board;
  EXPECT_NE(complaint_of(pairs), "none");
}

}  // namespace
}  // namespace prosector
