#pragma once
// Scrolls the text of a tracked user's panel with a fingertip drawn along it.

#include <array>
#include <optional>

#include "client/app/desk/panel_scroll.h"
#include "common/hand_messages.h"

namespace prosector {

class PanelFinger {
 public:
  /// Updates from the user's own panel and hands. `hidden_lines`: lines of its description that do not fit.
  void follow(const std::optional<Panel>& panel, std::size_t hidden_lines, const HandInput& user);
  /// Returns the first visible line.
  std::size_t line() const { return scroll_.line(); }

 private:
  PanelScroll scroll_;
  std::array<std::optional<double>, 2>
      heights_;  // m, heights of fingertips on the text, panel frame; nullopt: not on it
};

}  // namespace prosector
