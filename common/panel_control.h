#pragma once
// The controls of a part's panel and their state.

#include <cstddef>
#include <cstdint>

namespace prosector {

/// Buttons and slider of an anatomical part's control panel, in the order of the table in common/panel.h.
enum class PanelControl : std::uint8_t {
  attach,        // button: in its place, or free
  hide_others,   // button
  transparency,  // button: opaque, or half seen through
  light_shaft,   // button: the lamp's light falls on the part
  room_lights,   // button: bright, or dimmed
  stiffness      // slider: ¼ … 4 times the scene's, ½ is 1
};
inline constexpr std::size_t panel_control_count = 6;

inline constexpr double min_stiffness = 0.25, max_stiffness = 4;

/// State of one button or slider of a control panel.
struct ControlState {
  double position = 0;   // button: 0 at rest … 1 fully pressed; slider: 0 … 1
  bool on = false;       // button: switched on
  bool touched = false;  // touched or pointed at by a finger
};

}  // namespace prosector
