#pragma once
// Which gesture five flexions make: fingers are open or closed by two thresholds, a table names the pattern.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "common/messages.h"

namespace prosector {

/// How the thumb must be: `bent` is not open, as thumbs hardly close.
enum class ThumbNeed : std::uint8_t { any, open, bent };

/// One row of the table of gestures. Bits of open fingers: index 1, middle 2, ring 4, little 8. Patterns
/// without a row are Gesture::none. Those that need no thumb are numbered after the 5DT SDK.
struct GestureRow {
  Gesture gesture;
  const char* name;
  int open_fingers;  // −1: no pattern (none)
  ThumbNeed thumb = ThumbNeed::any;
  bool if_asked = false;  // told only where GestureThresholds::pinch is
};
std::span<const GestureRow> gesture_table();
const char* gesture_name(Gesture gesture);
/// Returns the row of the gesture of that name, or nullptr.
const GestureRow* find_gesture(std::string_view name);
/// Returns the gesture of the same four fingers for which the thumb doesn't count; without one, `gesture`.
Gesture without_thumb(Gesture gesture);

struct GestureThresholds {
  double closed_above = 0, open_below = 0;  // flexion
  double hysteresis = 0;                    // a finger keeps its state this far past its threshold
  bool pinch = false;                       // index closed, thumb bent, the others open
};

struct DeviceConfig;
/// Returns the thresholds that a device is configured to have.
GestureThresholds thresholds_of(const DeviceConfig& device);

class GestureDetector {
 public:
  explicit GestureDetector(const GestureThresholds& thresholds) : thresholds_(thresholds) {}
  /// Takes the next flexions and returns the gesture: Gesture::none while any of the four fingers is between
  /// open and closed.
  Gesture update(const std::array<double, fingers>& flexion);

 private:
  enum class Finger : std::uint8_t { between, open, closed };
  Finger classify(double flexion, Finger before) const;
  bool is_made(const GestureRow& row, int open_fingers) const;

  GestureThresholds thresholds_;
  std::array<Finger, fingers> fingers_{};
};

}  // namespace prosector
