#include "server/physics/mechanics/hands/grip.h"

#include <algorithm>
#include <array>
#include <optional>

namespace prosector::hands {

std::size_t digit_of(std::size_t part) {
  constexpr std::size_t thumb_segments = 2, finger_segments = 3;
  if (part == 0) return digits - 1;
  const std::size_t segment = part - 1;
  return segment < thumb_segments ? 0 : 1 + (segment - thumb_segments) / finger_segments;
}

bool encloses(std::span<const Touch> touches) {
  return std::any_of(touches.begin(), touches.end(), [&](const Touch& touch) {
    return digit_of(touch.part) != digit_of(touches.front().part);
  });
}

std::vector<Touch> holding_touches(std::vector<Touch> touches) {
  if (!encloses(touches)) return {};
  std::vector<Touch> real = touches;
  std::erase_if(real, [](const Touch& touch) { return touch.gap > touching_gap; });
  return encloses(real) ? real : touches;
}

std::vector<Touch> nearest_of_each_digit(std::span<const Touch> touches) {
  std::array<std::optional<Touch>, digits> nearest;
  for (const Touch& touch : touches) {
    auto& best = nearest[digit_of(touch.part)];
    if (!best || touch.gap < best->gap) best = touch;
  }
  std::vector<Touch> out;
  for (const auto& touch : nearest)
    if (touch) out.push_back(*touch);
  return out;
}

}  // namespace prosector::hands
