#pragma once
// How far fingers are bent in each gesture, as people make it.

#include <algorithm>

#include "drivers/device/gesture.h"

namespace prosector {

inline constexpr double open_bend = 0.05, closed_bend = 0.9;
inline constexpr double bent_thumb = 0.6;  // a hand's thumb hardly closes

/// Tells whether people make this gesture with an open thumb: where it must be, or where a bent one would
/// make another gesture.
inline bool opens_thumb(const GestureRow& row) {
  const auto all = gesture_table();
  return row.thumb == ThumbRequirement::open ||
         (row.thumb == ThumbRequirement::any &&
          std::any_of(all.begin(), all.end(), [&](const GestureRow& other) {
            return other.open_fingers == row.open_fingers && other.thumb == ThumbRequirement::bent;
          }));
}

inline std::array<double, fingers> bends_of(const GestureRow& row) {
  std::array<double, fingers> out{};
  out[0] = opens_thumb(row) ? open_bend : bent_thumb;
  for (std::size_t f = 1; f < fingers; ++f)
    out[f] = row.open_fingers >> (f - 1) & 1 ? open_bend : closed_bend;
  return out;
}

/// Calls `use` with each gesture's row.
template <typename Use>
void for_gestures(const Use& use) {
  for (const GestureRow& row : gesture_table())
    if (row.gesture != Gesture::none) use(row);
}

}  // namespace prosector
