#pragma once
// The boards that everybody has: printed by `prosector-board`, known by name to drivers and calibration. No
// code is on two of them.

#include <string>
#include <vector>

#include "drivers/camera/tags/board.h"

namespace prosector {

struct KnownBoard {
  const char* name;
  TagGrid grid;
  const char* help;
  Pose worn = {};  // of the wrist, the eyes or the tip in the board's frame
};
const std::vector<KnownBoard>& known_boards();

/// Returns the pose of the wrist, the eyes or the tip in a known board's frame; of others the identity.
Pose worn_on(const std::string& name);
/// Returns a known board by name, else reads the file of that name (board.toml). Throws InputError that lists
/// the known ones.
Board find_board(const std::string& name_or_file);

}  // namespace prosector
