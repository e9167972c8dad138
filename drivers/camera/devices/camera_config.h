#pragma once
// Settings of a device's camera: its lens, and the board that gives its pose in the room.

#include <memory>
#include <numbers>
#include <string>

#include "common/math.h"

namespace prosector {

class SharedCamera;

/// Default pose, in the room frame, of the board that defines the camera's pose. It lies flat at the height
/// of the scenes' tables (0.9 m): its front faces up, its top edge points away from the user.
inline const Pose default_table_board_pose = {{0, 0.9, 0},
                                              Quat(std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2, 0, 0)};

struct CameraConfig {
  std::string lens;                            // calibration file; empty: parameters are guessed
  std::string table;                           // static board that defines the room frame; empty: none
  Pose room_table = default_table_board_pose;  // pose of that board in the room frame
  std::shared_ptr<SharedCamera> shared = {};   // camera shared with other devices; null: the device opens its
                                               // own
};

}  // namespace prosector
