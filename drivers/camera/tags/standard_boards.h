#pragma once
// Standard boards, printed by `prosector-board` and known by name to drivers and calibration. Their codes
// don't overlap.

#include <string>
#include <vector>

#include "drivers/camera/tags/board.h"

namespace prosector {

struct StandardBoard {
  const char* name;
  TagGrid grid;
  const char* help;
  Pose worn = {};  // pose of the wrist, the eyes or the tip in the board's frame
};
const std::vector<StandardBoard>& standard_boards();

/// Returns the pose of the wrist, the eyes or the tip in a standard board's frame; the identity for other
/// boards.
Pose board_wearer_pose(const std::string& name);
/// Returns a standard board by name, else reads the file of that name (board.toml). Throws InputError with
/// the list of standard boards.
Board find_board(const std::string& name_or_file);

}  // namespace prosector
