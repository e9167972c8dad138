#include "tests/camera/tag_errors.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/clock.h"
#include "drivers/camera/base/undistorter.h"
#include "drivers/camera/tags/tag_reader.h"

namespace prosector {
namespace {

/// Adds what hides the board's left side: grey, a little before it, carried with it.
void cover(SyntheticScene& scene, std::size_t carrier, const Board& board, double share) {
  Eigen::AlignedBox2d box;
  if (board.picture) {
    const Vec2 half(board.picture->width / 2, board.picture->height() / 2);
    box.extend(-half).extend(half);
  }
  for (const BoardTag& tag : board.tags)
    for (const Vec3& corner : tag.corners()) box.extend(corner.head<2>());
  TexturedQuad hand;
  hand.carrier = carrier;
  hand.width = share * box.sizes().x() + 0.04;
  hand.height = 2 * box.sizes().y();
  hand.pose.p = {box.min().x() - 0.04 + hand.width / 2, 0, 0.01};
  hand.both_sides = true;
  hand.texture =
      std::make_shared<Texture>(Image{1, 1, {190, 140, 120}}, false, Response(scene.sensor.response));
  scene.things.push_back(hand);
}

/// Measures what passes between its calls.
class Stopwatch {
 public:
  double lap_ms() {
    const std::int64_t now_ns = monotonic_ns();
    return static_cast<double>(now_ns - std::exchange(last_ns_, now_ns)) * 1e-6;
  }

 private:
  std::int64_t last_ns_ = monotonic_ns();
};

/// Lets a carrier pass a pose at the first picture's moment with that speed.
void move_through(Carrier& carrier, double moment, double speed) {
  // Keyframes are passed with 15/8 of the mean speed in the middle between them.
  constexpr double span = 0.2;
  const Vec3 half(speed * span / 2 / 1.875, 0, 0);
  carrier.motion.emplace();
  carrier.motion->add(0, moment - span / 2, Pose{carrier.pose.p - half, carrier.pose.q});
  carrier.motion->add(0, moment + span / 2, Pose{carrier.pose.p + half, carrier.pose.q});
}

/// Returns the scene of one place.
SyntheticScene scene_of(const TagCase& what, const Lens& lens, const Pose& room_board, unsigned seed) {
  SyntheticScene scene = usual_scene(lens);
  scene.sensor.response = what.response;
  scene.sensor.noise = what.noise;
  scene.sensor.light = what.light;
  scene.sensor.seed = seed;
  scene.exposure = what.exposure;
  Carrier carrier;
  carrier.pose = room_board;
  if (what.speed > 0) move_through(carrier, scene.seconds_of(0), what.speed);
  const std::size_t index = scene.add_board(what.board, carrier);
  if (what.covered > 0) cover(scene, index, what.board, what.covered);
  return scene;
}

struct Found {
  Pose pose, truth;
};

/// Looks at one picture, and measures how long that takes.
struct Watch {
  const GreyImage& picture;
  const Undistorter& straightener;
  const TagCase& what;
  TagErrors& out;
  std::int64_t next_ns;  // so late that a printed picture is searched

  struct Fit {
    Pose camera_board;
    MotionCovariance covariance;
  };

  std::optional<Fit> look_for_tags(const TagDetector& finder) {
    Stopwatch stopwatch;
    const GreyImage straight = straightener.straight(picture);
    out.straighten_ms.push_back(stopwatch.lap_ms());
    const std::vector<DetectedTag> tags = what.reads_on ? read_on(stopwatch) : finder.find(straight);
    out.find_ms.push_back(stopwatch.lap_ms());
    const auto poses = solve_board(corners_seen(what.board, tags), straightener.lens());
    if (poses.empty()) return std::nullopt;
    std::vector<int> codes;
    for (const DetectedTag& tag : tags) codes.push_back(tag.code);
    const Lens lens = usual_lens().scaled(what.width, what.height);
    const auto fit = fit_edges(picture, lens, what.board, codes, poses.front().camera_board, what.assumed);
    out.fit_ms.push_back(stopwatch.lap_ms());
    if (!fit) return std::nullopt;
    return Fit{fit->camera_board, fit->covariance};
  }

  /// Reads the picture again and again.
  std::vector<DetectedTag> read_on(Stopwatch& stopwatch) const {
    TagReader reader(CameraCalibration{"synthetic", usual_lens().scaled(what.width, what.height)});
    reader.expect(what.board);
    Frame frame{{what.width, what.height, {}}, 0, 0};
    for (const std::uint8_t grey : picture.grey) frame.image.rgb.insert(frame.image.rgb.end(), 3, grey);
    for (; frame.number < 2; ++frame.number, frame.time_ns += 33'333'333) (void)reader.read(frame);
    (void)stopwatch.lap_ms();
    return reader.read(frame).tags;
  }

  /// Searches, then follows, which a person sees in all pictures but the first.
  std::optional<Fit> look_for_picture(BoardTracker& tracker) {
    Stopwatch stopwatch;
    TagImage seen{picture, straightener.straight(picture), {}, next_ns};
    out.straighten_ms.push_back(stopwatch.lap_ms());
    const TagOptics optics{usual_lens().scaled(what.width, what.height), straightener.lens(), what.assumed};
    if (!tracker.update(seen, optics)) return std::nullopt;
    out.find_ms.push_back(stopwatch.lap_ms());
    const auto at = tracker.update(seen, optics);
    out.fit_ms.push_back(stopwatch.lap_ms());
    tracker.forget();
    if (!at) return std::nullopt;
    return Fit{at->camera_board, *at->spread};
  }
};

void judge(const std::vector<Found>& found, TagErrors& out) {
  for (const Found& one : found) {
    const Vec3 off = 1e3 * (one.pose.p - one.truth.p);
    out.depth.push_back(std::abs(off.z()));
    out.lateral.push_back(off.head<2>().norm());
    out.turn.push_back(one.pose.q.angularDistance(one.truth.q));
  }
}

/// Takes the mean of what was found for the truth, so that scatter alone is left.
void take_mean_for_truth(std::vector<Found>& found) {
  Vec3 sum = Vec3::Zero();
  Eigen::Vector4d turn = Eigen::Vector4d::Zero();
  for (const Found& one : found) {
    sum += one.pose.p;
    turn += (one.pose.q.coeffs().dot(found.front().pose.q.coeffs()) < 0 ? -1 : 1) * one.pose.q.coeffs();
  }
  Quat mean;
  mean.coeffs() = turn.normalized();
  for (Found& one : found) one.truth = {sum / static_cast<double>(found.size()), mean};
}

}  // namespace

TagErrors tag_errors(const TagCase& what) {
  Random random(11);
  const Lens lens = usual_lens().scaled(what.width, what.height);
  const Undistorter straightener(lens);
  const TagDetector finder(what.finder);
  TagErrors out;
  std::optional<BoardTracker> tracker;
  if (what.board.picture) tracker.emplace(what.board);
  std::vector<Found> found;
  Pose room_board;
  for (int k = 0; k < what.places; ++k) {
    if (k == 0 || !what.still)
      room_board = board_before_camera(random, what.distance, what.least_tilt, what.most_tilt);
    const SyntheticScene scene = scene_of(what, lens, room_board, static_cast<unsigned>(k + 1));
    const GreyImage picture = grey_of(SceneRenderer(scene).paint(0));
    Watch watch{picture, straightener, what, out, 1'000'000'000LL * k};
    const auto fit = tracker ? watch.look_for_picture(*tracker) : watch.look_for_tags(finder);
    if (!fit) continue;
    ++out.seen;
    out.told.push_back(1e3 * std::sqrt(fit->covariance(5, 5)));
    found.push_back({fit->camera_board, device_camera * room_board});
  }
  if (what.still && !found.empty()) take_mean_for_truth(found);
  judge(found, out);
  return out;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace prosector
