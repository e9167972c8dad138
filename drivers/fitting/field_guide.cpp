#include "drivers/fitting/field_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double least_spacing = 0.02, least_reach = 0.06;  // m
constexpr std::size_t most_per_axis = 12;

/// Returns the grid's points in boustrophedon order, so that consecutive points are neighbours.
std::vector<Vec3> points_of(const FieldGrid& grid) {
  std::vector<Vec3> out;
  const auto at = [&](Eigen::Index axis, std::size_t i) {
    const auto steps = static_cast<double>(grid.count[static_cast<std::size_t>(axis)] - 1);
    return grid.low[axis] + (grid.high[axis] - grid.low[axis]) * static_cast<double>(i) / steps;
  };
  std::size_t row = 0;
  for (std::size_t y = 0; y < grid.count[1]; ++y)
    for (std::size_t zz = 0; zz < grid.count[2]; ++zz, ++row) {
      const std::size_t z = y % 2 == 0 ? zz : grid.count[2] - 1 - zz;
      for (std::size_t xx = 0; xx < grid.count[0]; ++xx) {
        const std::size_t x = row % 2 == 0 ? xx : grid.count[0] - 1 - xx;
        out.emplace_back(at(0, x), at(1, y), at(2, z));
      }
    }
  return out;
}

/// Returns the least distance between neighbours. Throws InputError for an invalid grid.
double spacing_of(const FieldGrid& grid) {
  double least = 1e9;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (grid.count[axis] < 3 || grid.count[axis] > most_per_axis)
      throw InputError(fmt::format("a grid has 3 to {} points along each axis", most_per_axis));
    const auto i = static_cast<Eigen::Index>(axis);
    least = std::min(least, (grid.high[i] - grid.low[i]) / static_cast<double>(grid.count[axis] - 1));
  }
  if (least < least_spacing)
    throw InputError(
        fmt::format("a grid's points must be at least {:.0f} mm apart along each axis", 1e3 * least_spacing));
  return least;
}

}  // namespace

FieldGuide::FieldGuide(const ClientConfig& config, StationRole role, const FieldGrid& grid, std::string file)
    : room_device_(config.tracker_device.placement.room_device),
      station_(station_of_role(config, role)),
      grid_(grid),
      file_(std::move(file)),
      catcher_(0.4 * spacing_of(grid), {.seconds = 0.3}),
      reach_(std::max(least_reach, spacing_of(grid))) {
  points_ = points_of(grid);
}

DeviceConfig FieldGuide::device(const ClientConfig& config) {
  DeviceConfig out = config.tracker_device;
  out.placement.room_device = {};
  out.placement.mount.fill({});
  out.placement.field_map.clear();
  return out;
}

void FieldGuide::take(const DeviceSample& sample) {
  if (sample.station != station_ || !sample.has_trusted_pose() || caught_.size() == points_.size()) return;
  const auto place = catcher_.take(sample.time_ns, sample.pose);
  if (!place) return;
  rejection_.clear();
  const double off = (room_device_ * place->p - points_[caught_.size()]).norm();
  if (off <= reach_)
    caught_.push_back({*place, catcher_.error()});
  else
    rejection_ = fmt::format(
        "the receiver seems to be {:.0f} mm from the instructed position: move it there, or run the room "
        "calibration first",
        1e3 * off);
}

GuideStep FieldGuide::step() const {
  GuideStep out = step_at(caught_.size(), points_.size(), rejection_);
  if (out.done) return out;
  const Vec3& p = points_[out.index];
  out.instruction =
      fmt::format("Hold the receiver at {:.3f}, {:.3f}, {:.3f} m, in the same orientation, and keep it still",
                  p.x(), p.y(), p.z());
  out.target = p;
  out.progress = catcher_.held();
  return out;
}

std::vector<FieldSample> FieldGuide::samples() const {
  const Pose device_room = room_device_.inverse();
  Quat turn = Quat::Identity();
  if (grid_.orientation) {
    turn = device_room.q * *grid_.orientation;
  } else {
    // The pose nearest to the transmitter is used, because the field is least distorted there.
    double nearest = 1e9;
    for (const auto& [x, error] : caught_)
      if (x.p.norm() < nearest) {
        nearest = x.p.norm();
        turn = x.q;
      }
  }
  std::vector<FieldSample> out;
  for (std::size_t i = 0; i < caught_.size(); ++i)
    out.push_back({caught_[i].pose, {device_room * points_[i], turn}});
  return out;
}

FieldFit FieldGuide::fit() const {
  PoseErrors squares;
  for (const auto& [pose, error] : caught_) {
    squares.position += error.position * error.position;
    squares.turn += error.turn * error.turn;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(1, caught_.size()));
  return fit_field(samples(), {std::sqrt(squares.position / n), std::sqrt(squares.turn / n)});
}

void FieldGuide::back() {
  if (!caught_.empty()) caught_.pop_back();
}

GuideOutcome FieldGuide::outcome() const {
  return outcome_of(fit());
}

GuideOutcome FieldGuide::outcome_of(const FieldFit& f) const {
  constexpr double degrees = 180 / std::numbers::pi;
  GuideOutcome out;
  out.words.push_back(fmt::format(
      "error before: {:.2f} mm, {:.2f}° RMS; error after: {:.2f} mm, {:.2f}° RMS expected between the points",
      1e3 * f.before, degrees * f.turn_before, 1e3 * f.after, degrees * f.turn_after));
  out.words.push_back(
      "chosen: " + f.chosen.name() +
      "; position and rotation errors of each model of the tracker's field, expected between the measured "
      "points, and position error at points not used for its fit:");
  for (const FieldTrial& t : f.trials)
    out.words.push_back(fmt::format("  {:<26} {:6.2f} mm {:6.2f}°, {:6.2f} mm", t.name(),
                                    1e3 * t.expected.position, degrees * t.expected.turn, 1e3 * t.left_out));
  out.changes = {{"tracker.field_map", file_}};
  return out;
}

}  // namespace prosector
