#pragma once
// Scrolls the text of a tracked user's panel with a fingertip drawn along it.

#include <array>
#include <optional>

#include "client/app/desk/panel_scroll.h"
#include "common/hand_messages.h"

namespace prosector {

class PanelFinger {
 public:
  /// Scrolls the text of the user's own panel by the motion of their fingertips along it. `panel`: the open
  /// panel, nullopt: none. `hidden_lines`: lines of its description that do not fit. `user`: present hand
  /// poses.
  void follow(const std::optional<Panel>& panel, std::size_t hidden_lines, const HandInput& user);
  /// Returns the index of the first visible line of the panel's description.
  std::size_t line() const { return scroll_.line(); }

 private:
  PanelScroll scroll_;
  std::array<std::optional<double>, 2>
      heights_;  // m, heights of fingertips on the text, panel frame; nullopt: not on it
};

}  // namespace prosector
