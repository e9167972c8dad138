#include "drivers/fitting/phantom_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "drivers/config/tracker_roles.h"
#include "drivers/device/driver_table.h"

namespace prosector {

PhantomGuide::PhantomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points,
                           std::vector<Vec3> targets)
    : RoomGuide(config, role, std::move(points)), targets_(std::move(targets)) {
  if (!config.phantom.has_shape())
    throw InputError("phantom: the configuration defines no shape: set body or mesh in [phantom]");
}

DeviceConfig PhantomGuide::device(const ClientConfig& config) {
  DeviceConfig out = config.tracker_device;
  if (config.phantom.board.empty()) return out;
  const DriverRow& driver = driver_of(board_tracker_address(config.tracker));
  if (!driver.is_camera || driver.fixes_head_station)
    throw InputError(
        fmt::format("phantom.board {}: needs a camera that also tracks the tip's board: tracker must be "
                    "tags:CAMERA or hands:CAMERA; with {} omit the board, and do not move the phantom",
                    config.phantom.board, driver.name));
  out.camera.table = config.phantom.board;
  out.camera.room_table = {};
  return out;
}

GuideOutcome PhantomGuide::outcome() const {
  const RigidFit f = fit();
  GuideOutcome out;
  if (targets_.empty())
    out.words.push_back(fmt::format("expected position error between the touched points: {:.2f} mm RMS",
                                    1e3 * f.expected_error(f.centre)));
  for (const Vec3& target : targets_)
    out.words.push_back(fmt::format("expected error at {:.3f}, {:.3f}, {:.3f} m: {:.2f} mm RMS", target.x(),
                                    target.y(), target.z(), 1e3 * f.expected_error(target)));
  const auto worst = std::max_element(f.residuals.begin(), f.residuals.end());
  out.words.push_back(fmt::format("error of the touched positions {:.2f} mm RMS, largest at point {}",
                                  1e3 * f.fle, worst - f.residuals.begin() + 1));
  const Pose shape = f.room_device.inverse();
  out.changes = {{"phantom.position", written(shape.p)}, {"phantom.orientation", written(shape.q)}};
  return out;
}

}  // namespace prosector
