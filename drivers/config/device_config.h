#pragma once
// Settings of a device of any driver, as the client's configuration gives them. A driver sees only its own
// groups: its row in drivers/drivers.cpp selects them.

#include "drivers/camera/devices/board_tracking_config.h"
#include "drivers/camera/devices/camera_config.h"
#include "drivers/camera/devices/face_tracking_config.h"
#include "drivers/camera/devices/hand_tracking_config.h"
#include "drivers/device/gesture.h"
#include "drivers/device/placement.h"
#include "drivers/gloves/glove_config.h"
#include "drivers/trackers/fastrak_config.h"

namespace prosector {

struct DeviceConfig {
  Placement placement;         // trackers
  FastrakConfig fastrak;       // `fastrak`
  CameraConfig camera;         // `tags`, `hands`, `face`
  BoardTrackingConfig tags;    // `tags`
  HandTrackingConfig hands;    // `hands`
  FaceTrackingConfig face;     // `face`
  GestureThresholds gestures;  // gloves, and bare hands
  GloveConfig glove;           // gloves, and the channels of `vrpn`
};

}  // namespace prosector
