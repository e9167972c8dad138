#pragma once
// JSON messages of Ultraleap's WebSocket, version 6: one text per frame. Lengths are mm in the messages and m
// here; x right, y up, z to the user.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/hand_pose.h"
#include "common/math.h"

namespace prosector::leap {

inline constexpr int known_version = 6;
inline constexpr const char* default_port = "6437";
inline constexpr const char* target = "/v6.json";

/// Joint positions of a finger (m, Ultraleap's frame), from the wrist on: carpus, knuckle, two joints, tip.
/// The first two of the thumb coincide.
using Finger = std::array<Vec3, 5>;

struct Hand {
  bool left = false;
  Vec3 wrist = Vec3::Zero();
  Vec3 direction = Vec3::Zero(), palm_normal = Vec3::Zero();  // unit vectors: towards the fingers; out of the
                                                              // palm
  std::array<Finger, fingers> joints;                         // thumb first
};

/// A decoded message of Ultraleap's service: a greeting with the protocol version, an event, or a frame with
/// the tracked hands.
struct Text {
  std::optional<int> version;     // of a greeting
  bool is_event = false;          // event of a device, or of an unknown type
  std::optional<bool> streaming;  // of a device event: whether the camera is present and streaming
  std::vector<Hand> hands;        // of a frame
};
/// Parses a JSON message of Ultraleap's service. Returns nothing if the text is not a greeting, an event or a
/// frame, or a hand is implausible.
std::optional<Text> read_text(std::string_view text);
std::string text_of(const Text& text, std::int64_t frame);
/// Returns the two messages that ask Ultraleap's service for frames: as a background program, and as the
/// program with the focus. The service sends no frames to a program that has neither state.
std::vector<std::string> ask_for_frames();

/// Returns the wrist's pose of a hand (m, Ultraleap's frame): −z along the hand, y out of its back.
Pose wrist_of(const Hand& hand);
/// Computes a hand's finger flexions, thumb first, comparable to those of a glove's sensors; 90° is 1. A
/// finger's flexion is 2/3 of the knuckle angle plus 1/3 of the next joint's angle. The thumb's flexion is
/// the mean of its two joint angles.
std::array<double, fingers> flexion_of(const Hand& hand);

}  // namespace prosector::leap
