#include "tests/hands/hand_trial.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "drivers/camera/hands/hand_fit.h"
#include "drivers/camera/hands/hand_tracker.h"
#include "drivers/device/gesture_flexions.h"
#include "tests/gesture_bends.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

constexpr double wrong_points = 0.1;  // of the hand's length

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Vec3 palm_middle(const PosedHand& hand) {
  return hand.camera_wrist * Vec3(hand.size * hand_palm(hand.hand).center);
}

/// One camera with its finder.
struct Eye {
  HandFinder finder;
  Pose camera_rig;
};

/// Shows pictures of one hand to one or two cameras, and judges what comes out.
class TrialRun {
 public:
  TrialRun(const std::filesystem::path& nets, HandNets size, const HandPainter& painter, std::size_t cameras,
           unsigned seed)
      : painter_(painter), random_(seed) {
    for (std::size_t k = 0; k < cameras; ++k)
      eyes_.push_back(
          {HandFinder(nets, size), {Vec3(-0.12 * static_cast<double>(k), 0, 0), Quat::Identity()}});
  }

  Random& random() { return random_; }

  void forget() {
    before_.reset();
    for (Eye& eye : eyes_) eye.finder.forget();
  }

  /// Shows a picture. Returns how the hand is taken to be, where it is.
  std::optional<HandFit> show(HandScene scene) {
    const PosedHand& hand = scene.hands[0];
    ++trial.pictures;
    std::vector<HandView> views;
    bool right_side = true;
    double find_ms = 0;
    for (Eye& eye : eyes_) {
      scene.camera_rig = eye.camera_rig;
      const Image image = painter_.paint(scene, random_);
      const double start = thread_ms();
      const std::vector<DetectedHand>& found = eye.finder.find(image);
      find_ms += thread_ms() - start;
      if (found.empty()) continue;
      views.push_back({found[0].points, scene.lens, eye.camera_rig, found[0].depths});
      right_side = right_side && found[0].left == (hand.hand == left_hand);
      judge_points(scene, hand, found[0].points);
    }
    trial.find_ms.add(find_ms);
    trial.palm_runs = 0;
    for (const Eye& eye : eyes_) trial.palm_runs += eye.finder.palm_runs();
    if (views.empty()) return before_ = std::nullopt;
    ++trial.seen;
    trial.right_side += right_side;
    const double start = thread_ms();
    before_ = fit_hand(views, {hand.hand, hand.size}, before_);
    trial.fit_ms.add(thread_ms() - start);
    if (before_ && before_->sure) judge_fit(hand, *before_);
    return before_;
  }

  HandTrial trial;

 private:
  void judge_points(const HandScene& scene, const PosedHand& hand, const HandPoints& points) {
    const auto truth = true_points(scene, hand);
    const double length = length_in_picture(scene, hand);
    double sum = 0;
    for (std::size_t k = 0; k < hand_points; ++k) sum += (points[k] - truth[k]).norm() / length / hand_points;
    ++trial.views;
    if (sum > wrong_points) return;
    ++trial.right_points;
    for (std::size_t k = 0; k < hand_points; ++k) trial.points.add((points[k] - truth[k]).norm() / length);
  }

  void judge_fit(const PosedHand& hand, const HandFit& fit) {
    ++trial.sure;
    const Vec3 off = fit.wrist * Vec3(hand.size * hand_palm(hand.hand).center) - palm_middle(hand);
    trial.lateral.add(off.head<2>().norm());
    trial.depth.add(std::abs(off.z()));
    trial.turn.add(fit.wrist.q.angularDistance(hand.camera_wrist.q));
    for (std::size_t f = 0; f < fingers; ++f) trial.flexion.add(std::abs(fit.flexion[f] - hand.flexion[f]));
  }

  const HandPainter& painter_;
  Random random_;
  std::vector<Eye> eyes_;
  std::optional<HandFit> before_;
};

/// A value that swings between bounds.
struct Swing {
  double middle, reach, rate, phase;
  double at(double seconds) const {
    return middle + reach * std::sin(2 * 3.14159265 * rate * seconds + phase);
  }
};

Swing random_swing(Random& random, double low, double high) {
  return {(low + high) / 2, (high - low) / 2, random.uniform(0.2, 0.5), random.uniform(0, 6.28)};
}

/// Shows hands that make gestures to what a device would track and tell them by.
class GestureMaker {
 public:
  GestureMaker(const std::filesystem::path& nets, HandNets size, const HandPainter& painter)
      : painter_(painter), tracker_(nets, size, 1) {}

  /// Shows one hand that rests open, makes a gesture within 0.13 s and rests again; pictures show rest twice
  /// or more.
  void make(const GestureRow& row, unsigned seed, GestureTrial& trial) {
    constexpr int open_pictures = 6, moving = 4, held = 4;
    Random random(seed);
    HandScene scene = random_scene(random, random_hand(random, 0.35, 0.6));
    PosedHand& hand = scene.hands[0];
    std::array<double, fingers> made = bends_of(row);
    for (double& bend : made) bend += random.uniform(-0.05, 0.1);
    GestureThresholds thresholds;
    thresholds.pinch = true;
    std::array<GestureDetector, 2> detectors{GestureDetector(thresholds), GestureDetector(thresholds)};
    tracker_.set_camera_setup(0, {scene.lens, {}});
    now_ns_ += 1'000'000'000;
    Gesture told = Gesture::none;
    bool right_side = false;
    Image image;
    for (int k = 0; k < open_pictures + moving + held; ++k) {
      const double way = std::clamp((k - open_pictures + 1.0) / moving, 0.0, 1.0);
      for (std::size_t f = 0; f < fingers; ++f) hand.flexion[f] = open_bend + way * (made[f] - open_bend);
      const int rested = k - open_pictures - moving;
      if (k == 0 || (k >= open_pictures && rested != 1 && rested != 3)) image = painter_.paint(scene, random);
      now_ns_ += 33'333'333;
      for (const TrackedHand& tracked : tracker_.see(0, {image, now_ns_, 0})) {
        told = detectors[tracked.hand].update(gesture_flexions(tracked.flexion));
        right_side = tracked.hand == hand.hand;
      }
      if (rested < 0) continue;
      ++trial.told[row.gesture][told];
      ++trial.pictures;
      trial.right_side += right_side;
    }
  }

 private:
  const HandPainter& painter_;
  HandTracker tracker_;
  std::int64_t now_ns_ = 0;
};

}  // namespace

double ErrorList::at(double share) const {
  if (errors_.empty()) return std::nan("");
  std::vector<double> sorted = errors_;
  std::sort(sorted.begin(), sorted.end());
  return sorted[std::min(sorted.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

double ErrorList::mean() const {
  double sum = 0;
  for (const double e : errors_) sum += e;
  return sum / static_cast<double>(errors_.size());
}

HandTrial first_sight(const std::filesystem::path& nets, HandNets size, const HandPainter& painter,
                      std::size_t pictures, unsigned seed) {
  TrialRun run(nets, size, painter, 1, seed);
  for (std::size_t k = 0; k < pictures; ++k) {
    run.forget();
    run.show(random_scene(run.random(), random_hand(run.random(), 0.35, 0.7)));
  }
  return run.trial;
}

HandTrial followed_hand(const std::filesystem::path& nets, HandNets size, const HandPainter& painter,
                        std::size_t pictures, std::size_t cameras, unsigned seed) {
  TrialRun run(nets, size, painter, cameras, seed);
  PosedHand hand = random_hand(run.random(), 0.35, 0.7);
  HandScene scene = random_scene(run.random(), hand);
  std::array<Swing, 6> ways;
  for (std::size_t k = 0; k < 3; ++k) ways[k] = random_swing(run.random(), -0.04, 0.04);
  for (std::size_t k = 3; k < 6; ++k) ways[k] = random_swing(run.random(), -0.25, 0.25);
  std::array<Swing, fingers> bends;
  for (Swing& bend : bends) bend = random_swing(run.random(), 0, &bend == &bends[0] ? 0.7 : 1);
  hand.camera_wrist.p.z() = std::clamp(hand.camera_wrist.p.z(), 0.4, 0.65);
  const Pose start = hand.camera_wrist;
  for (std::size_t k = 0; k < pictures; ++k) {
    const double t = static_cast<double>(k) / 30;
    PosedHand& shown = scene.hands[0];
    shown.camera_wrist.p = start.p + Vec3(ways[0].at(t), ways[1].at(t), ways[2].at(t));
    shown.camera_wrist.q = (Quat(Eigen::AngleAxisd(ways[3].at(t), Vec3::UnitX())) *
                            Eigen::AngleAxisd(ways[4].at(t), Vec3::UnitY()) *
                            Eigen::AngleAxisd(ways[5].at(t), Vec3::UnitZ()) * start.q)
                               .normalized();
    for (std::size_t f = 0; f < fingers; ++f) shown.flexion[f] = bends[f].at(t);
    run.show(scene);
  }
  return run.trial;
}

std::size_t GestureTrial::pictures_of(Gesture made) const {
  std::size_t sum = 0;
  if (const auto row = told.find(made); row != told.end())
    for (const auto& [gesture, count] : row->second) sum += count;
  return sum;
}

double GestureTrial::right_share(Gesture made) const {
  const auto row = told.find(made);
  const auto right = row == told.end() || !row->second.contains(made) ? 0 : row->second.at(made);
  return static_cast<double>(right) / static_cast<double>(pictures_of(made));
}

GestureTrial made_gestures(const std::filesystem::path& nets, HandNets size, const HandPainter& painter,
                           std::size_t views, unsigned seed) {
  GestureTrial out;
  GestureMaker maker(nets, size, painter);
  for_gestures([&](const GestureRow& row) {
    for (unsigned view = 0; view < views; ++view)
      maker.make(row, seed + 100 * static_cast<unsigned>(row.gesture) + view, out);
  });
  return out;
}

std::filesystem::path fetched_nets() {
  return std::filesystem::path(find_in_data("palm_full.tflite")).parent_path();
}

}  // namespace prosector
