#pragma once
// The control panel of an anatomical part: a board with physical buttons and a slider. This table of its
// layout is shared by the server, which moves the controls, and the clients, which draw them.
//
// Panel frame: origin at the centre of the board's front, +x to the reader's right, +y up, +z towards the
// reader. Metres.

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "common/math.h"
#include "common/panel_control.h"

namespace prosector {

inline constexpr double panel_width = 0.30, panel_height = 0.26, panel_thickness = 0.008;  // of the board
inline constexpr double panel_margin = 0.012;  // from the board's edge to its contents

/// Area on a control panel for the anatomical part's name and description: its bounds in the panel frame, m.
struct PanelBox {
  double left, right, bottom, top;
};
inline constexpr PanelBox panel_info{-panel_width / 2 + panel_margin, panel_width / 2 - panel_margin, 0.052,
                                     panel_height / 2 - panel_margin};
inline constexpr double panel_name_height = 0.016, panel_text_height = 0.0115;  // of a line of text
inline constexpr double panel_head_height = 1.6 * panel_name_height;            // of the area of the name
inline constexpr double panel_head_bottom = panel_info.top - panel_head_height;

enum class ControlKind : std::uint8_t {
  button,  // moves along −z; a spring returns it
  slider   // moves along x; friction holds it in position
};

struct ControlDesc {
  PanelControl control;
  ControlKind kind;
  std::string_view label;  // label while off
  std::string_view label_on;
  double x, y;                     // of its centre; slider: at mid-travel
  double half_width, half_height;  // of the cap
  double height;                   // of the cap's face above the board, at rest
  double travel;                   // of the cap, m
};

inline constexpr double button_travel = 0.007, button_height = 0.010, knob_height = 0.016;
inline constexpr double slider_y = -0.096;

/// Layout of a control panel's buttons and slider: position, size, labels and travel of each, in the order of
/// PanelControl.
inline constexpr std::array<ControlDesc, panel_control_count> panel_controls = {{
    {PanelControl::attach, ControlKind::button, "attach", "detach", -0.071, 0.028, 0.067, 0.016,
     button_height, button_travel},
    {PanelControl::hide_others, ControlKind::button, "hide others", "show others", 0.071, 0.028, 0.067, 0.016,
     button_height, button_travel},
    {PanelControl::transparency, ControlKind::button, "transparent", "opaque", -0.071, -0.012, 0.067, 0.016,
     button_height, button_travel},
    {PanelControl::light_shaft, ControlKind::button, "light shaft", "light off", 0.071, -0.012, 0.067, 0.016,
     button_height, button_travel},
    {PanelControl::room_lights, ControlKind::button, "room bright", "dim room", -0.071, -0.052, 0.067, 0.016,
     button_height, button_travel},
    {PanelControl::stiffness, ControlKind::slider, "stiffness", "stiffness", 0, slider_y, 0.010, 0.016,
     knob_height, 0.23},
}};

constexpr const ControlDesc& describe(PanelControl control) {
  return panel_controls[static_cast<std::size_t>(control)];
}

/// Returns the centre of the outer face of a control's cap (m, panel frame) for a position of 0 … 1. For a
/// button 0 is at rest and 1 fully pressed; for a slider they are the ends of its travel.
inline Vec3 control_face(const ControlDesc& control, double position) {
  if (control.kind == ControlKind::slider)
    return {control.x + (position - 0.5) * control.travel, control.y, control.height};
  return {control.x, control.y, control.height - position * control.travel};
}

/// Returns the stiffness factor of a body for a position (0 … 1) of the panel's slider.
/// position_of_stiffness() is the inverse. The factor is ¼ … 4 on a logarithmic scale, so position ½ is 1.
inline double stiffness_at(double position) {
  return min_stiffness * std::pow(max_stiffness / min_stiffness, position);
}
inline double position_of_stiffness(double stiffness) {
  return std::log(stiffness / min_stiffness) / std::log(max_stiffness / min_stiffness);
}

}  // namespace prosector
