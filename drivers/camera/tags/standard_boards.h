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

/// Returns the pose of the tracked point (wrist, point between the eyes, or instrument tip) in the frame of
/// the standard board with this name. Returns the identity for other boards.
Pose board_wearer_pose(const std::string& name);
/// Returns the standard board with this name, or else reads the board from the file of that name, such as
/// "board.toml". Throws InputError with the list of standard boards if neither exists.
Board find_board(const std::string& name_or_file);

}  // namespace prosector
