#include "drivers/camera/hands/hand_fit.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr Eigen::Index first_bend = 6, breadth_at = first_bend + static_cast<Eigen::Index>(fingers),
                       unknowns = breadth_at + 1;  // translation and rotation come before the bends
using Step = Eigen::Matrix<double, unknowns, 1>;
using Normal = Eigen::Matrix<double, unknowns, unknowns>;

constexpr int quick_rounds = 8, last_rounds = 25;
constexpr double typical_residual =
    0.02;                              // share of the hand's length: typical error of the networks' points
constexpr double max_residual = 0.09;  // share of the hand's length; a fit with larger error is rejected
constexpr double continuity_factor = 0.7;  // factor on the cost of the fit that continues the previous pose,
                                           // so that others must be clearly better
constexpr double as_good = 1.15;           // ratio of costs up to which two poses are ambiguous
constexpr double bend_spread = 1.5;  // standard deviation of the prior on bends around `usual_bend`, which
                                     // keeps unobservable bends stable
constexpr double usual_bend = 0.3;
// Standard deviation of the breadth of hands of one length. With a fixed breadth, a slimmer hand that points
// straight at the camera appeared to be rotated to one side.
constexpr double breadth_spread = 0.08, most_breadth = 0.3;
constexpr double nearest_hand = 0.08, farthest_hand = 3;               // m along z, plausible range
constexpr std::array<std::size_t, 5> flat_points = {0, 5, 9, 13, 17};  // wrist, knuckles: unaffected by bends

/// Position at which the networks detect a point, fitted to their output on images of the hand model's skin.
/// It differs between bent and straight fingers.
struct SeenPoint {
  std::size_t joint;         // joint with whose segment the point moves
  bool at_end = false;       // relative to the segment's end
  Vec3 offset = {0, 0, 0};   // m, for the right hand
  Vec3 by_bend = {0, 0, 0};  // m, added in proportion to the finger's bend
};
constexpr std::size_t of_the_wrist = hand_joints;
const std::array<SeenPoint, hand_points> seen_points = {
    {{of_the_wrist, false, {0.0054, 0.0011, -0.0112}, {0.0000, 0.0000, 0.0000}},
     {of_the_wrist, false, {-0.0256, -0.0112, -0.0351}, {0.0038, -0.0067, 0.0036}},
     {0, false, {-0.0011, -0.0020, -0.0172}, {-0.0041, 0.0053, 0.0032}},
     {1, false, {-0.0005, -0.0006, -0.0026}, {0.0002, -0.0039, 0.0069}},
     {1, true, {-0.0012, -0.0037, 0.0013}, {0.0116, 0.0166, 0.0203}},
     {of_the_wrist, false, {-0.0250, -0.0004, -0.0947}, {0.0029, 0.0023, 0.0044}},
     {2, true, {-0.0003, -0.0012, 0.0001}, {0.0032, 0.0086, 0.0174}},
     {4, false, {-0.0013, 0.0009, 0.0023}, {0.0051, -0.0143, 0.0031}},
     {4, true, {-0.0009, 0.0037, 0.0035}, {0.0056, -0.0099, 0.0137}},
     {of_the_wrist, false, {-0.0033, 0.0003, -0.0940}, {0.0006, 0.0019, 0.0044}},
     {5, true, {0.0009, -0.0009, 0.0042}, {0.0007, 0.0069, 0.0102}},
     {7, false, {0.0005, -0.0008, 0.0067}, {0.0012, -0.0125, -0.0056}},
     {7, true, {0.0004, 0.0022, 0.0048}, {0.0006, -0.0072, 0.0050}},
     {of_the_wrist, false, {0.0175, 0.0002, -0.0907}, {-0.0007, -0.0003, 0.0057}},
     {8, true, {0.0007, -0.0031, 0.0027}, {0.0000, 0.0066, 0.0084}},
     {10, false, {0.0002, -0.0038, 0.0059}, {-0.0012, -0.0077, -0.0085}},
     {10, true, {-0.0008, -0.0016, 0.0077}, {-0.0022, -0.0040, -0.0039}},
     {of_the_wrist, false, {0.0360, -0.0007, -0.0877}, {-0.0009, -0.0024, 0.0062}},
     {11, true, {0.0011, -0.0009, -0.0027}, {-0.0031, 0.0019, 0.0107}},
     {13, false, {0.0015, -0.0006, 0.0002}, {-0.0063, -0.0071, -0.0009}},
     {13, true, {0.0010, 0.0014, 0.0030}, {-0.0074, -0.0054, 0.0041}}}};

/// Returns the finger of a point; the wrist counts as the thumb.
constexpr std::size_t finger_of(std::size_t point) {
  return point == 0 ? 0 : (point - 1) / 4;
}

/// Returns the weight of a point. It is lower at the thumb's root and knuckle, where hands differ from the
/// hand model.
constexpr double weight_of(std::size_t point) {
  return point == 1 ? 0 : point == 2 ? 0.5 : 1;
}

/// The unknowns of the fit.
struct Guess {
  Pose wrist;
  std::array<double, fingers> flexion{};
  double breadth = 1;
  double cost = 0;
};

/// One camera's points as directions at distance 1.
struct Seen {
  std::array<Vec2, hand_points> directions;
  Pose camera_rig;
  double length = 1;  // length of the hand in the image, as a direction
  std::optional<HandDepths> depths;
};

class HandProblem {
 public:
  HandProblem(std::vector<Seen> seen, const HandShape& shape) : seen_(std::move(seen)), shape_(shape) {}

  Guess improve(Guess guess, int rounds) const {
    double damping = 1e-3;
    guess.cost = cost_of(guess);
    for (int round = 0; round < rounds && damping < 1e6; ++round) {
      Normal normal;
      Step slope;
      linearise(guess, normal, slope);
      bool better = false;
      while (!better && damping < 1e6) {
        Normal damped = normal;
        damped.diagonal() *= 1 + damping;
        damped.diagonal().array() += 1e-9;
        const Guess next = moved(guess, damped.ldlt().solve(-slope));
        better = next.cost < guess.cost;
        damping *= better ? 0.3 : 5;
        if (!better) continue;
        const bool settled = guess.cost - next.cost < 1e-5 * guess.cost;
        guess = next;
        if (settled) return guess;
      }
    }
    return guess;
  }

  /// Returns the correlation between a guess's depths along the first camera's axis and the network's depths,
  /// −1 to 1; 0 if the latter are unknown.
  double depth_agreement(const Guess& guess) const {
    const Seen& seen = seen_.front();
    if (!seen.depths) return 0;
    const auto points = points_of(guess);
    const Pose camera_wrist = seen.camera_rig * guess.wrist;
    Eigen::Array<double, hand_points, 1> fitted, seen_depths;
    for (std::size_t k = 0; k < hand_points; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      fitted[row] = (camera_wrist * points[k]).z();
      seen_depths[row] = (*seen.depths)[k];
    }
    fitted -= fitted.mean();
    seen_depths -= seen_depths.mean();
    const double both = (fitted * seen_depths).sum(),
                 each = fitted.square().sum() * seen_depths.square().sum();
    return each > 0 && std::isfinite(both) ? both / std::sqrt(each) : 0;
  }

  /// Returns the weighted RMS residual of the points, as a share of the hand's length.
  double miss_of(const Guess& guess) const {
    double sum = 0, weights = 0;
    for_points(guess, [&](const Vec2& miss, double weight) {
      const double square = miss.squaredNorm() * typical_residual * typical_residual;
      sum += weight * square;
      weights += weight;
    });
    return std::sqrt(sum / weights);
  }

 private:
  /// Returns the points of the guessed hand in its wrist's frame, m.
  std::array<Vec3, hand_points> points_of(const Guess& guess) const {
    auto out = points_of_hand(shape_.hand, guess.flexion);
    for (Vec3& point : out) point = shape_.size * Vec3(guess.breadth * point.x(), point.y(), point.z());
    return out;
  }

  /// Calls `use` with each point's residual, in units of the typical error, and its weight.
  template <typename Use>
  void for_points(const Guess& guess, const Use& use) const {
    const auto points = points_of(guess);
    for (const Seen& seen : seen_) {
      const Pose camera_wrist = seen.camera_rig * guess.wrist;
      for (std::size_t k = 0; k < hand_points; ++k) {
        const Vec3 x = camera_wrist * points[k];
        const double z = std::max(x.z(), 0.01);
        use(Vec2((x.head<2>() / z - seen.directions[k]) / (typical_residual * seen.length)), weight_of(k));
      }
    }
  }

  double cost_of(const Guess& guess) const {
    double out = 0;
    for_points(guess, [&](const Vec2& miss, double weight) {
      out += weight * std::log1p(miss.squaredNorm() / 4) * 4;
    });
    for (const double bend : guess.flexion)
      out += (bend - usual_bend) * (bend - usual_bend) / (bend_spread * bend_spread);
    return out + (guess.breadth - 1) * (guess.breadth - 1) / (breadth_spread * breadth_spread);
  }

  /// Applies a step. Rotates about the palm's centre, so that rotation and translation are nearly decoupled.
  Guess moved(const Guess& from, const Step& step) const {
    Guess out = from;
    const Vec3 middle = from.wrist * Vec3(shape_.size * hand_palm(shape_.hand).center);
    const Vec3 turn = step.segment<3>(3);
    const double angle = turn.norm();
    const Quat q = angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
    out.wrist.q = (q * from.wrist.q).normalized();
    out.wrist.p = middle + q * (from.wrist.p - middle) + step.head<3>();
    for (std::size_t f = 0; f < fingers; ++f)
      out.flexion[f] =
          std::clamp(from.flexion[f] + step[first_bend + static_cast<Eigen::Index>(f)], 0.0, 1.0);
    out.breadth = std::clamp(from.breadth + step[breadth_at], 1 - most_breadth, 1 + most_breadth);
    out.cost = cost_of(out);
    return out;
  }

  std::vector<double> misses(const Guess& guess) const {
    std::vector<double> out;
    for_points(guess, [&](const Vec2& miss, double) {
      out.push_back(miss.x());
      out.push_back(miss.y());
    });
    return out;
  }

  void linearise(const Guess& guess, Normal& normal, Step& slope) const {
    const std::vector<double> here = misses(guess);
    const auto rows = static_cast<Eigen::Index>(here.size());
    Eigen::MatrixXd by(rows, unknowns);
    for (Eigen::Index k = 0; k < unknowns; ++k) {
      Step step = Step::Zero();
      // Bends are limited to 0 … 1, so finite differences go inwards.
      const bool is_bend = k >= first_bend && k < breadth_at;
      const double inwards =
          is_bend && guess.flexion[static_cast<std::size_t>(k - first_bend)] > 0.5 ? -1 : 1;
      step[k] = k < 3 ? 1e-5 : inwards * 1e-4;
      const std::vector<double> there = misses(moved(guess, step));
      for (Eigen::Index r = 0; r < rows; ++r)
        by(r, k) = (there[static_cast<std::size_t>(r)] - here[static_cast<std::size_t>(r)]) / step[k];
    }
    Eigen::VectorXd weights(rows), miss(rows);
    Eigen::Index row = 0;
    for_points(guess, [&](const Vec2& m, double weight) {
      const double robust = weight / (1 + m.squaredNorm() / 4);
      for (Eigen::Index c = 0; c < 2; ++c, ++row) {
        weights[row] = robust;
        miss[row] = m[c];
      }
    });
    normal = by.transpose() * weights.asDiagonal() * by;
    slope = by.transpose() * weights.cwiseProduct(miss);
    for (std::size_t f = 0; f < fingers; ++f) {
      const auto at = first_bend + static_cast<Eigen::Index>(f);
      normal(at, at) += 1 / (bend_spread * bend_spread);
      slope[at] += (guess.flexion[f] - usual_bend) / (bend_spread * bend_spread);
    }
    normal(breadth_at, breadth_at) += 1 / (breadth_spread * breadth_spread);
    slope[breadth_at] += (guess.breadth - 1) / (breadth_spread * breadth_spread);
  }

  std::vector<Seen> seen_;
  HandShape shape_;
};

/// Returns the two poses in the camera's frame that map the flat hand to its points in weak perspective.
std::vector<Pose> flat_poses(const Seen& seen, const HandShape& shape) {
  const auto points = points_of_hand(shape.hand, {});
  Vec2 mean_seen = Vec2::Zero(), mean_flat = Vec2::Zero();
  for (const std::size_t k : flat_points) {
    mean_seen += seen.directions[k] / static_cast<double>(flat_points.size());
    mean_flat += shape.size * Vec2(points[k].x(), points[k].z()) / static_cast<double>(flat_points.size());
  }
  Eigen::Matrix2d across = Eigen::Matrix2d::Zero(), square = across;
  for (const std::size_t k : flat_points) {
    const Vec2 flat = shape.size * Vec2(points[k].x(), points[k].z()) - mean_flat;
    across += (seen.directions[k] - mean_seen) * flat.transpose();
    square += flat * flat.transpose();
  }
  const Eigen::Matrix2d map = across * square.inverse();  // columns: images of the hand's x and z axes
  const double a = map.col(0).squaredNorm(), b = map.col(1).squaredNorm(), c = map.col(0).dot(map.col(1));
  // Both axes have the same length in space: a + s² = b + t², c + s·t = 0.
  const double scale2 = (a + b + std::sqrt((a - b) * (a - b) + 4 * c * c)) / 2;
  if (!(scale2 > 1 / (farthest_hand * farthest_hand)) || !std::isfinite(scale2)) return {};
  const double scale = std::sqrt(scale2), s = std::sqrt(std::max(scale2 - a, 0.0)),
               t = (c > 0 ? -1 : 1) * std::sqrt(std::max(scale2 - b, 0.0));
  std::vector<Pose> out;
  for (const double sign : {1.0, -1.0}) {
    Vec3 x(map(0, 0), map(1, 0), sign * s), z(map(0, 1), map(1, 1), sign * t);
    x.normalize();
    z = (z - z.dot(x) * x).normalized();
    Mat3 turn;
    turn << x, z.cross(x), z;
    const double depth = std::max(1 / scale, nearest_hand);
    Pose pose;
    pose.q = Quat(turn).normalized();
    pose.p = depth * Vec3(mean_seen.x(), mean_seen.y(), 1) - pose.q * Vec3(mean_flat.x(), 0, mean_flat.y());
    out.push_back(pose);
  }
  return out;
}

std::optional<Seen> seen_by(const HandView& view) {
  Seen out;
  out.camera_rig = view.camera_rig;
  out.depths = view.depths;
  for (std::size_t k = 0; k < hand_points; ++k) {
    out.directions[k] = view.lens.ray(view.points[k]).head<2>();
    if (!out.directions[k].allFinite()) return std::nullopt;
  }
  out.length = std::max(length_of_hand(out.directions), 1e-3);
  return out;
}

/// Returns, among the guesses with costs about as low as the first, the one whose depths agree best with the
/// network's. Returns the first if depths are unknown. `guesses`: not empty, sorted by cost.
const Guess& resolve_ambiguity(const HandProblem& problem, const std::vector<Guess>& guesses) {
  const Guess* best = &guesses.front();
  double best_agreement = problem.depth_agreement(*best);
  for (const Guess& rival : guesses) {
    if (rival.cost > as_good * guesses.front().cost) break;
    const double agreement = problem.depth_agreement(rival);
    if (agreement <= best_agreement) continue;
    best = &rival;
    best_agreement = agreement;
  }
  return *best;
}

}  // namespace

std::array<Vec3, hand_points> points_of_hand(std::size_t hand, const std::array<double, fingers>& flexion) {
  const auto pose = hand_pose(hand, flexion);
  const auto& segments = hand_segments(hand);
  const double side = hand == right_hand ? 1 : -1;
  std::array<Vec3, hand_points> out;
  for (std::size_t k = 0; k < hand_points; ++k) {
    const SeenPoint& seen = seen_points[k];
    Vec3 at = seen.offset + flexion[finger_of(k)] * seen.by_bend;
    at.x() *= side;
    if (seen.at_end) at.z() -= segments[seen.joint].length;
    out[k] = seen.joint == of_the_wrist ? at : pose[seen.joint] * at;
  }
  return out;
}

std::optional<HandFit> fit_hand(std::span<const HandView> views, const HandShape& shape,
                                const std::optional<HandFit>& before) {
  std::vector<Seen> seen;
  for (const HandView& view : views)
    if (const auto one = seen_by(view)) seen.push_back(*one);
  if (seen.empty()) return std::nullopt;
  const HandProblem problem(seen, shape);
  std::vector<Guess> guesses;
  if (before) {
    guesses.push_back(problem.improve({before->wrist, before->flexion, before->breadth}, quick_rounds));
    guesses.back().cost *= continuity_factor;
  }
  for (const Pose& camera_wrist : flat_poses(seen[0], shape))
    for (const double bend : {0.2, 0.7}) {
      std::array<double, fingers> all;
      all.fill(bend);
      guesses.push_back(problem.improve({seen[0].camera_rig.inverse() * camera_wrist, all}, quick_rounds));
    }
  if (guesses.empty()) return std::nullopt;
  std::sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
  const Guess best = problem.improve(before ? guesses[0] : resolve_ambiguity(problem, guesses), last_rounds);
  HandFit out{best.wrist, best.flexion, best.breadth, problem.miss_of(best), false};
  const double depth = (seen[0].camera_rig * best.wrist).p.z();
  out.sure =
      is_finite(best.wrist) && out.miss < max_residual && depth > nearest_hand && depth < farthest_hand;
  return out;
}

}  // namespace prosector
