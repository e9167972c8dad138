#include "drivers/gesture.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::array<GestureRow, 9> table = {{
    {Gesture::none, "none", -1},
    {Gesture::fist, "fist", 0},
    {Gesture::point, "point", 1},
    {Gesture::two, "two", 3},
    {Gesture::three, "three", 7},
    {Gesture::little, "little", 8},
    {Gesture::index_little, "index_little", 9},
    {Gesture::flat, "flat", 15},
    {Gesture::pinch, "pinch", -1},
}};

constexpr int all_but_index = 2 + 4 + 8;

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

GestureDetector::Finger GestureDetector::classify(double flexion, Finger before) const {
  const double h = thresholds_.hysteresis;
  if (flexion > thresholds_.closed_above - (before == Finger::closed ? h : 0)) return Finger::closed;
  if (flexion < thresholds_.open_below + (before == Finger::open ? h : 0)) return Finger::open;
  return Finger::between;
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
  if (thresholds_.pinch && fingers_[0] == Finger::closed && open == all_but_index) return Gesture::pinch;
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.open_fingers == open; });
  return row == table.end() ? Gesture::none : row->gesture;
}

}  // namespace prosector
