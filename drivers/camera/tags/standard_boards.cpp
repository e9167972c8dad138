#include "drivers/camera/tags/standard_boards.h"

#include <fmt/format.h>

#include <numbers>

#include "common/error.h"

namespace prosector {

namespace {

/// Makes a pose from a rotation about an axis (rad) and a translation (m).
Pose turned(double angle, const Vec3& axis, const Vec3& place) {
  return {place, Quat(Eigen::AngleAxisd(angle, axis))};
}

constexpr double quarter = std::numbers::pi / 2;

}  // namespace

const std::vector<StandardBoard>& standard_boards() {
  static const std::vector<StandardBoard> rows = {
      {"table", {5, 3, 0.045, 0.01125, 0}, "board on the table that defines the room frame"},
      {"tablet", {4, 3, 0.03, 0.008, 20}, "held in the hand; shows the panel"},
      {"calibration", {6, 4, 0.036, 0.009, 40}, "for calibrating a camera"},
      // The board's upper side points to the fingers: the hand's −z is the board's y; the back of the hand
      // faces the board's z.
      {"wrist-right",
       {2, 2, 0.022, 0.0055, 70},
       "worn on the back of the right hand, upper side towards the fingers",
       turned(quarter, Vec3::UnitX(), {0, -0.05, -0.02})},
      {"wrist-left",
       {2, 2, 0.022, 0.0055, 74},
       "worn on the back of the left hand, upper side towards the fingers",
       turned(quarter, Vec3::UnitX(), {0, -0.05, -0.02})},
      {"head",
       {3, 1, 0.03, 0.0075, 80},
       "worn on the forehead",
       turned(2 * quarter, Vec3::UnitY(), {0, -0.06, -0.02})},
      {"instrument",
       {1, 2, 0.03, 0.0075, 90},
       "fixed to an instrument that points in the direction of its lower side",
       turned(-quarter, Vec3::UnitX(), {0, -0.12, 0})},
  };
  return rows;
}

Pose board_wearer_pose(const std::string& name) {
  for (const StandardBoard& row : standard_boards())
    if (name == row.name) return row.worn;
  return {};
}

Board find_board(const std::string& name_or_file) {
  for (const StandardBoard& row : standard_boards())
    if (name_or_file == row.name) return grid_board(row.name, row.grid);
  if (name_or_file.ends_with(".toml")) return load_board(name_or_file);
  std::string names;
  for (const StandardBoard& row : standard_boards())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
  throw InputError(
      fmt::format("board \"{}\": unknown; allowed: {}, or a file that ends with .toml", name_or_file, names));
}

}  // namespace prosector
