#pragma once
// What Ultraleap's WebSocket says, version 6: texts in JSON, one a frame. m here, mm there; x right, y up, z
// to the user.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/math.h"
#include "common/messages.h"

namespace prosector::leap {

inline constexpr int known_version = 6;
inline constexpr const char* usual_port = "6437";
inline constexpr const char* target = "/v6.json";

/// Where a finger's bones meet, from the wrist on: carpus, knuckle, two joints, tip. The thumb's first two
/// are one place.
using Finger = std::array<Vec3, 5>;

struct Hand {
  bool left = false;
  Vec3 wrist = Vec3::Zero();
  Vec3 direction = Vec3::Zero(), palm_normal = Vec3::Zero();  // to the fingers; out of the palm
  std::array<Finger, fingers> joints;                         // thumb first
};

/// A text of the service: a greeting, an event or a frame.
struct Text {
  std::optional<int> version;     // of a greeting
  bool is_event = false;          // of a device, or one that isn't known
  std::optional<bool> streaming;  // of a device's event: its camera is there and sends
  std::vector<Hand> hands;        // of a frame
};
/// Returns nothing for what is no greeting, event or frame, and for hands that can be none.
std::optional<Text> read_text(std::string_view text);
std::string text_of(const Text& text, std::int64_t frame);
/// Returns the texts that ask for frames: in the background, too, and as a program that has the focus. The
/// service sends frames to no program that has neither.
std::vector<std::string> ask_for_frames();

/// Returns the wrist's pose: −z along the hand, y out of its back.
Pose wrist_of(const Hand& hand);
/// Returns bends as a glove's sensors would see them; 90° is 1. A finger's is 2/3 of the knuckle's angle and
/// 1/3 of the next joint's. The thumb's is the mean of its two.
std::array<double, fingers> flexion_of(const Hand& hand);

}  // namespace prosector::leap
