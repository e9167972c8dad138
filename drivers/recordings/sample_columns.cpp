#include "drivers/recordings/sample_columns.h"

#include <fmt/format.h>

#include "common/ids.h"
#include "drivers/device/device.h"

namespace prosector {
namespace {

constexpr std::array<const char*, fingers> finger_columns = {"thumb", "index", "middle", "ring", "little"};
constexpr double unit_tolerance = 0.01;

bool any(const CsvTable& table, std::size_t row, std::initializer_list<const char*> columns) {
  for (const char* c : columns)
    if (!table.text(row, c).empty()) return true;
  return false;
}

}  // namespace

const std::vector<std::string>& sample_columns() {
  static const std::vector<std::string> columns = {"time", "station", "x",       "y",      "z",     "qw",
                                                   "qx",   "qy",      "qz",      "thumb",  "index", "middle",
                                                   "ring", "little",  "gesture", "buttons"};
  return columns;
}

std::uint32_t read_station(const CsvTable& table, std::size_t row) {
  const double station = table.number(row, "station").value_or(1);
  for (std::uint32_t s = 0; s < max_stations; ++s)
    if (station == s + 1) return s;
  table.fail(row, fmt::format("station: must be 1 to {}", max_stations));
}

std::optional<Pose> read_pose(const CsvTable& table, std::size_t row) {
  if (!any(table, row, {"x", "y", "z", "qw", "qx", "qy", "qz"})) return std::nullopt;
  Pose pose;
  pose.p = {table.required(row, "x"), table.required(row, "y"), table.required(row, "z")};
  if (pose.p.cwiseAbs().maxCoeff() > max_coordinate)
    table.fail(row, fmt::format("x, y, z: must be within {} m", max_coordinate));
  if (any(table, row, {"qw", "qx", "qy", "qz"}))
    pose.q = Quat(table.required(row, "qw"), table.required(row, "qx"), table.required(row, "qy"),
                  table.required(row, "qz"));
  if (std::abs(pose.q.norm() - 1) > unit_tolerance)
    table.fail(row, "qw, qx, qy, qz: the quaternion must have length 1");
  pose.q.normalize();
  return pose;
}

std::optional<std::array<double, fingers>> read_flexion(const CsvTable& table, std::size_t row) {
  if (!any(table, row, {"thumb", "index", "middle", "ring", "little"})) return std::nullopt;
  std::array<double, fingers> flexion{};
  for (std::size_t i = 0; i < fingers; ++i) {
    flexion[i] = table.required(row, finger_columns[i]);
    if (flexion[i] < 0 || flexion[i] > 1)
      table.fail(row, fmt::format("{}: must be 0 to 1", finger_columns[i]));
  }
  return flexion;
}

}  // namespace prosector
