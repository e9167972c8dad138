#include "drivers/fitting/eyes_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace prosector {
namespace {

// A head moves more than an object on a table.
constexpr StillnessLimits head_limits = {.seconds = 0.3, .motion = 4e-3, .turn = 0.01, .least = 10};
constexpr std::array<const char*, 2> distances = {"at arm's length", "from three steps away"};

constexpr double least_way = 0.01;  // m, least motion of the mark in the head's frame between crosses

}  // namespace

EyesGuide::EyesGuide(const ClientConfig& config, const Vec3& mark, int width, int height, std::size_t crosses)
    : mark_(mark),
      width_(width),
      height_(height),
      crosses_(std::clamp(crosses, min_seen_points, max_crosses)),
      station_(station_of_role(config, StationRole::head)),
      window_(head_limits) {}

DeviceConfig EyesGuide::device(const ClientConfig& config) {
  DeviceConfig out = config.tracker_device;
  out.placement.mount[station_of_role(config, StationRole::head)] = {};
  return out;
}

void EyesGuide::take(const DeviceSample& sample) {
  if (sample.station == station_ && sample.has_trusted_pose()) window_.take(sample.time_ns, sample.pose);
}

/// Returns the position of the current cross, on a 5 × 4 grid. Successive crosses are far apart.
Eigen::Vector2d EyesGuide::cross() const {
  constexpr std::size_t columns = 5, rows = 4, stride = 7;
  const std::size_t place = covered() % crosses_ * stride % max_crosses;
  return {width_ * (static_cast<double>(place % columns) + 0.5) / columns,
          height_ * (static_cast<double>(place / columns) + 0.5) / rows};
}

bool EyesGuide::confirm() {
  rejection_.clear();
  if (covered() == 2 * crosses_) {
    rejection_ = "all crosses are confirmed: finish, or repeat the last step";
    return false;
  }
  if (!window_.still()) {
    rejection_ = "the head moved: hold it still while you confirm";
    return false;
  }
  const Vec3 point = window_.mean().inverse() * mark_;
  const std::vector<SeenPoint>& last = seen_[seen_[1].empty() ? 0 : 1];
  if (!last.empty() && (point - last.back().point).norm() < least_way) {
    rejection_ = "the head has not moved: align this cross with the mark first";
    return false;
  }
  seen_[right_eye() ? 1 : 0].push_back({point, cross()});
  return true;
}

GuideStep EyesGuide::step() const {
  GuideStep out = step_at(covered(), 2 * crosses_, rejection_);
  if (out.done) return out;
  out.instruction =
      fmt::format("With the {} eye only, align the cross with the mark {}, hold still and confirm",
                  right_eye() ? "right" : "left", distances[out.index % distances.size()]);
  out.target = mark_;
  out.pixel = cross();
  out.progress = window_.filled();
  return out;
}

void EyesGuide::back() {
  rejection_.clear();
  std::vector<SeenPoint>& last = seen_[seen_[1].empty() ? 0 : 1];
  if (!last.empty()) last.pop_back();
}

GuideOutcome EyesGuide::outcome() const {
  const EyeFit left = fit(false), right = fit(true);
  const EyesFit eyes = join_eyes(left, right);
  GuideOutcome out = eyes_outcome(left, right, eyes);
  const std::string mount = "tracker.stations.head.mount.";
  out.changes.push_back({"tracker.stations.head.station", static_cast<double>(station_ + 1)});
  out.changes.push_back({mount + "position", written(eyes.head.p)});
  out.changes.push_back({mount + "orientation", written(eyes.head.q)});
  return out;
}

GuideOutcome eyes_outcome(const EyeFit& left, const EyeFit& right, const EyesFit& eyes) {
  constexpr double degree = std::numbers::pi / 180;
  GuideOutcome out;
  out.words.push_back(
      fmt::format("residual error {:.2f} pixels for the left eye, {:.2f} pixels for the right eye",
                  left.residual, right.residual));
  out.words.push_back(fmt::format("eyes {:.1f} mm apart, {:.1f}° × {:.1f}° each", 1e3 * eyes.distance,
                                  eyes.fov_horizontal / degree, eyes.fov_vertical / degree));
  out.changes = {{"eyes.distance", eyes.distance},
                 {"eyes.fov_horizontal", eyes.fov_horizontal / degree},
                 {"eyes.fov_vertical", eyes.fov_vertical / degree}};
  if (eyes.convergence > 0) out.changes.push_back({"eyes.convergence", eyes.convergence});
  return out;
}

}  // namespace prosector
