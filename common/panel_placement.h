#pragma once
// Where a command to open a panel puts it, if the sender's panel is open already.

#include <cstdint>

namespace prosector {

enum class PanelPlacement : std::uint32_t {
  stays,     // extends the time that the panel stays open; opens one if none is open
  put,       // moves the panel's centre to the command's `at` and faces it to its owner's eyes
  put_back,  // returns the panel to the position at which it opened
};
inline constexpr PanelPlacement last_panel_placement = PanelPlacement::put_back;

}  // namespace prosector
