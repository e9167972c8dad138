#pragma once
// Converts a headset's hand tracking to a wrist pose and five flexions.
//
// XR_EXT_hand_tracking gives 26 joints: palm, wrist, four of the thumb, five of each finger. A joint's −z is
// along its bone to the tip, its +y out of the back of the hand. Its wrist is this program's wrist. This
// program's finger bends by MCP = PIP = 90° · x and DIP = 2/3 · PIP (common/hand.h). Hence x is fitted by
// least squares to three angles a: x = Σ w a / (90° Σ w²), w = (1, 1, 2/3). The thumb has two, w = (1, 1).

#include "client/xr/tracked_user.h"

namespace prosector {

inline constexpr std::size_t headset_joints = 26;  // in the order of XrHandJointEXT
using HeadsetJoints = std::array<Pose, headset_joints>;

/// Returns wrist pose and finger flexions fitted to the 26 hand joints that a headset tracks, in the frame of
/// `joints`. Returns nullopt if a pose is not finite.
std::optional<TrackedHand> hand_of_joints(const HeadsetJoints& joints);

/// State of a headset's hand controller. Its grip pose is OpenXR's, at the palm's surface: +x goes into the
/// right palm and out of the left one, −z from the little finger to the thumb.
struct ControllerState {
  Pose grip;
  double trigger = 0, squeeze = 0;  // 0 … 1
};

/// Returns wrist pose and flexions of the hand that holds a controller. `hand`: left_hand or right_hand. The
/// trigger closes all fingers, for grasping; the squeeze control closes all but the index finger, which then
/// points. Returns nullopt for non-finite values.
std::optional<TrackedHand> hand_of_controller(std::size_t hand, const ControllerState& state);

}  // namespace prosector
