#pragma once
// Which gesture five flexions make: fingers are open or closed by two thresholds, a table names the pattern.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "common/messages.h"

namespace prosector {

/// One row of the table of gestures. Bits of open fingers: index 1, middle 2, ring 4, little 8; the thumb
/// doesn't count. Patterns without a row are Gesture::none. Numbering after the 5DT SDK.
struct GestureRow {
  Gesture gesture;
  const char* name;
  int open_fingers;  // −1: no pattern of its own (none, pinch)
};
std::span<const GestureRow> gesture_table();
const char* gesture_name(Gesture gesture);
/// Returns the row of the gesture of that name, or nullptr.
const GestureRow* find_gesture(std::string_view name);

struct GestureThresholds {
  double closed_above = 0, open_below = 0;  // flexion
  double hysteresis = 0;                    // a finger keeps its state this far past its threshold
  bool pinch = false;                       // thumb and index closed, the others open
};

class GestureDetector {
 public:
  explicit GestureDetector(const GestureThresholds& thresholds) : thresholds_(thresholds) {}
  /// Takes the next flexions and returns the gesture: Gesture::none while any finger is between open and
  /// closed.
  Gesture update(const std::array<double, fingers>& flexion);

 private:
  enum class Finger : std::uint8_t { between, open, closed };
  Finger classify(double flexion, Finger before) const;

  GestureThresholds thresholds_;
  std::array<Finger, fingers> fingers_{};
};

}  // namespace prosector
