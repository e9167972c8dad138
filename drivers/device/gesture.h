#pragma once
// Classifies five flexions as a gesture: two thresholds decide whether a finger is open or closed; a table
// maps the pattern to a gesture.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "common/hand_pose.h"

namespace prosector {

/// State of the thumb that a gesture requires. `bent` means any state other than open, since thumbs rarely
/// close fully. `any` means that the thumb does not matter.
enum class ThumbRequirement : std::uint8_t { any, open, bent };

/// One row of the table of hand gestures: a gesture, its name, and the required finger states. `open_fingers`
/// is a bit mask: index 1, middle 2, ring 4, little 8. Finger patterns without a row are Gesture::none.
/// Gestures that ignore the thumb have the numbers of the 5DT glove's SDK.
struct GestureRow {
  Gesture gesture;
  const char* name;
  int open_fingers;  // −1: no pattern (none)
  ThumbRequirement thumb = ThumbRequirement::any;
  bool requires_pinch_option = false;  // recognised only if GestureThresholds::pinch is set
};
std::span<const GestureRow> gesture_table();
const char* gesture_name(Gesture gesture);
/// Returns the row of the gesture table with this gesture name, or nullptr if the name is unknown.
const GestureRow* find_gesture(std::string_view name);
/// Returns the gesture that requires the same state of the four fingers but ignores the thumb. Returns
/// `gesture` unchanged if there is none.
Gesture without_thumb(Gesture gesture);

struct GestureThresholds {
  double closed_above = 0.65, open_below = 0.35;  // flexion
  double hysteresis = 0.05;  // a finger keeps its state until its flexion is this far past its threshold
  bool pinch = false;        // index closed, thumb bent and the others open is a pinch
};

class GestureDetector {
 public:
  explicit GestureDetector(const GestureThresholds& thresholds) : thresholds_(thresholds) {}
  /// Updates the open or closed state of each finger from its flexion (0 open … 1 closed, thumb first) and
  /// returns the gesture. Returns Gesture::none while any of the four fingers other than the thumb is neither
  /// open nor closed.
  Gesture update(const std::array<double, fingers>& flexion);

 private:
  enum class Finger : std::uint8_t { between, open, closed };
  Finger classify(double flexion, Finger before) const;
  bool matches_row(const GestureRow& row, int open_fingers) const;

  GestureThresholds thresholds_;
  std::array<Finger, fingers> fingers_{};
};

}  // namespace prosector
