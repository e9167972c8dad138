#include "drivers/camera/tags/known_boards.h"

#include <fmt/format.h>

#include <numbers>

#include "common/error.h"

namespace prosector {

namespace {

/// Makes a pose of a turn about an axis (rad) and a shift (m).
Pose turned(double angle, const Vec3& axis, const Vec3& place) {
  return {place, Quat(Eigen::AngleAxisd(angle, axis))};
}

constexpr double quarter = std::numbers::pi / 2;

}  // namespace

const std::vector<KnownBoard>& known_boards() {
  static const std::vector<KnownBoard> rows = {
      {"table", {5, 3, 0.045, 0.01125, 0}, "lies on the table and says where the room is"},
      {"tablet", {4, 3, 0.03, 0.008, 20}, "is held, and is the panel"},
      {"calibration", {6, 4, 0.036, 0.009, 40}, "is shown to a camera that is calibrated"},
      // Its upper side towards the fingers: a hand's −z is the board's y, the back of the hand looks along z.
      {"wrist-right",
       {2, 2, 0.022, 0.0055, 70},
       "is worn on the back of the right hand, its upper side towards the fingers",
       turned(quarter, Vec3::UnitX(), {0, -0.05, -0.02})},
      {"wrist-left",
       {2, 2, 0.022, 0.0055, 74},
       "is worn on the back of the left hand, its upper side towards the fingers",
       turned(quarter, Vec3::UnitX(), {0, -0.05, -0.02})},
      {"head",
       {3, 1, 0.03, 0.0075, 80},
       "is worn on the forehead",
       turned(2 * quarter, Vec3::UnitY(), {0, -0.06, -0.02})},
      {"instrument",
       {1, 2, 0.03, 0.0075, 90},
       "is fixed to an instrument that points where its lower side is",
       turned(-quarter, Vec3::UnitX(), {0, -0.12, 0})},
  };
  return rows;
}

Pose worn_on(const std::string& name) {
  for (const KnownBoard& row : known_boards())
    if (name == row.name) return row.worn;
  return {};
}

Board find_board(const std::string& name_or_file) {
  for (const KnownBoard& row : known_boards())
    if (name_or_file == row.name) return grid_board(row.name, row.grid);
  if (name_or_file.ends_with(".toml")) return load_board(name_or_file);
  std::string names;
  for (const KnownBoard& row : known_boards())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
  throw InputError(fmt::format("board \"{}\": is none of {}, and no file's name that ends with .toml",
                               name_or_file, names));
}

}  // namespace prosector
