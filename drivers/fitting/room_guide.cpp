#include "drivers/fitting/room_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double leave_distance = 0.03;  // m; known points are farther apart
constexpr int max_rejections = 2;        // attempts in a row before the previous point must be repeated, too
constexpr double most_mismatch = 0.06;   // m, of distances between points; more than a distorted field causes

constexpr double much_residual = 0.02;  // m RMS

/// Checks for mirrored positions. Throws InputError if the points fit far better when negated. The magnetic
/// field is symmetric, so a tracker reports negated positions on the wrong side of its hemisphere.
void check_not_mirrored(std::vector<TouchedPoint> points, double fre) {
  if (fre < much_residual) return;
  for (TouchedPoint& p : points) p.device = -p.device;
  if (fit_rigid(points).fre < fre / 3)
    throw InputError(
        "the tracker reports mirrored positions: its receivers are in the opposite hemisphere; change "
        "`hemisphere`, and touch the points again");
}

}  // namespace

RoomGuide::RoomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points)
    : station_(station_of_role(config, role)), points_(std::move(points)), catcher_(leave_distance) {
  std::vector<TouchedPoint> exact;
  for (const Vec3& p : points_) exact.push_back({p, p});
  (void)fit_rigid(exact);
  for (std::size_t i = 1; i < points_.size(); ++i)
    if ((points_[i] - points_[i - 1]).norm() < 2 * leave_distance)
      throw InputError(
          fmt::format("points {} and {} are closer than {:.0f} mm to each other: choose points farther apart",
                      i, i + 1, 2e3 * leave_distance));
}

DeviceConfig RoomGuide::device(const ClientConfig& config) {
  DeviceConfig out = config.tracker_device;
  out.placement.room_device = {};
  return out;
}

void RoomGuide::take(const DeviceSample& sample) {
  if (sample.station != station_ || !sample.has_trusted_pose() || touched_.size() == points_.size()) return;
  const auto place = catcher_.take(sample.time_ns, sample.pose);
  if (place && plausible(place->p)) touched_.push_back({place->p, points_[touched_.size()]});
}

/// Returns whether the position has the right distances from the earlier points; if not, sets the error
/// message.
bool RoomGuide::plausible(const Vec3& place) {
  rejection_.clear();
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    const double seen = (place - touched_[i].device).norm();
    const double known = (points_[touched_.size()] - touched_[i].room).norm();
    if (std::abs(seen - known) <= most_mismatch) continue;
    if (++refused_ == max_rejections) {
      // The earlier point may be the wrong one.
      back();
      refused_ = 0;
    }
    rejection_ =
        fmt::format("this point is {:.0f} mm from point {}, but should be {:.0f} mm: touch point {} again",
                    1e3 * seen, i + 1, 1e3 * known, touched_.size() + 1);
    return false;
  }
  refused_ = 0;
  return true;
}

GuideStep RoomGuide::step() const {
  GuideStep out = step_at(touched_.size(), points_.size(), rejection_);
  if (out.done) return out;
  const Vec3& p = points_[out.index];
  out.instruction = fmt::format("Touch point {} of {} at {:.3f}, {:.3f}, {:.3f} m and hold still",
                                out.index + 1, out.count, p.x(), p.y(), p.z());
  out.target = p;
  out.progress = catcher_.held();
  return out;
}

void RoomGuide::back() {
  if (!touched_.empty()) touched_.pop_back();
}

GuideOutcome RoomGuide::outcome() const {
  const RigidFit f = fit();
  check_not_mirrored(touched_, f.fre);
  GuideOutcome out;
  const auto worst = std::max_element(f.residuals.begin(), f.residuals.end());
  out.words.push_back(
      fmt::format("residual error {:.2f} mm RMS, at most {:.2f} mm at point {}; error of the touched "
                  "positions {:.2f} mm RMS",
                  1e3 * f.fre, 1e3 * *worst, worst - f.residuals.begin() + 1, 1e3 * f.fle));
  out.words.push_back(fmt::format(
      "expected position error: {:.2f} mm RMS between the touched points, {:.2f} mm half a metre above them",
      1e3 * f.expected_error(f.centre), 1e3 * f.expected_error(f.centre + Vec3(0, 0.5, 0))));
  out.changes = {{"tracker.room.position", written(f.room_device.p)},
                 {"tracker.room.orientation", written(f.room_device.q)}};
  return out;
}

}  // namespace prosector
