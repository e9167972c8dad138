#pragma once
// What a command to open a panel means by its `revision`, where the sender's panel is open already.

#include <cstdint>

namespace prosector {

enum class PanelPlacing : std::uint32_t {
  stays,     // it is kept open for a while; where none is open, one comes up
  put,       // its middle goes to the command's `shape.p`, and it turns to its owner's eyes
  put_back,  // it goes to where it came up
};
inline constexpr PanelPlacing last_panel_placing = PanelPlacing::put_back;

}  // namespace prosector
