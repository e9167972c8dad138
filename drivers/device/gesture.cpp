#include "drivers/device/gesture.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::array<GestureRow, 12> table = {{
    {Gesture::none, "none", -1},
    {Gesture::fist, "fist", 0},
    {Gesture::point, "point", 1},
    {Gesture::two, "two", 3},
    {Gesture::three, "three", 7},
    {Gesture::little, "little", 8},
    {Gesture::index_little, "index_little", 9},
    {Gesture::flat, "flat", 15},
    {Gesture::pinch, "pinch", 14, ThumbRequirement::bent, true},
    {Gesture::thumb_up, "thumb_up", 0, ThumbRequirement::open},
    {Gesture::thumb_index, "thumb_index", 1, ThumbRequirement::open},
    {Gesture::four, "four", 15, ThumbRequirement::bent},
}};

}  // namespace

std::span<const GestureRow> gesture_table() {
  return table;
}

const char* gesture_name(Gesture gesture) {
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.gesture == gesture; });
  return row == table.end() ? "none" : row->name;
}

const GestureRow* find_gesture(std::string_view name) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.name == name; });
  return row == table.end() ? nullptr : &*row;
}

Gesture without_thumb(Gesture gesture) {
  const auto own =
      std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.gesture == gesture; });
  const auto plain = std::find_if(table.begin(), table.end(), [&](const auto& r) {
    return own != table.end() && r.open_fingers == own->open_fingers && r.thumb == ThumbRequirement::any;
  });
  return plain == table.end() ? gesture : plain->gesture;
}

GestureDetector::Finger GestureDetector::classify(double flexion, Finger before) const {
  const double h = thresholds_.hysteresis;
  if (flexion > thresholds_.closed_above - (before == Finger::closed ? h : 0)) return Finger::closed;
  if (flexion < thresholds_.open_below + (before == Finger::open ? h : 0)) return Finger::open;
  return Finger::between;
}

bool GestureDetector::matches_row(const GestureRow& row, int open_fingers) const {
  const bool thumb_open = fingers_[0] == Finger::open;
  return row.open_fingers == open_fingers && (thresholds_.pinch || !row.requires_pinch_option) &&
         (row.thumb == ThumbRequirement::any || thumb_open == (row.thumb == ThumbRequirement::open));
}

Gesture GestureDetector::update(const std::array<double, fingers>& flexion) {
  int open = 0;
  bool between = false;
  for (std::size_t i = 0; i < fingers; ++i) {
    fingers_[i] = classify(flexion[i], fingers_[i]);
    if (i == 0) continue;  // the thumb has no bit
    if (fingers_[i] == Finger::open) open |= 1 << (i - 1);
    between = between || fingers_[i] == Finger::between;
  }
  if (between) return Gesture::none;
  Gesture made = Gesture::none;
  // A row that requires a thumb state takes precedence over one that ignores the thumb.
  for (const GestureRow& row : table)
    if (matches_row(row, open) && (made == Gesture::none || row.thumb != ThumbRequirement::any))
      made = row.gesture;
  return made;
}

}  // namespace prosector
