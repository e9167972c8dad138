#pragma once
// A tracked user's fingertip on the text of their panel: drawn along it, it scrolls.

#include <array>
#include <optional>

#include "client/app/panel_scroll.h"

namespace prosector {

class PanelFinger {
 public:
  /// Follows the user's own panel and their hands. `hidden_lines`: of its description, which do not fit.
  void follow(const std::optional<Panel>& panel, std::size_t hidden_lines, const HandInput& user);
  /// Returns the first line that is seen.
  std::size_t line() const { return scroll_.line(); }

 private:
  PanelScroll scroll_;
  std::array<std::optional<double>, 2> heights_;  // m, of tips at the text, in the panel's frame
};

}  // namespace prosector
