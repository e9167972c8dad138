#pragma once
// First visible line of the description on a viewer's panel.

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/ids.h"
#include "common/part_messages.h"

namespace prosector {

class PanelScroll {
 public:
  /// Updates the scroll range to the user's present panel. `hidden_lines`: lines of its description that do
  /// not fit. The panel of another part starts at its first line.
  void follow(const std::optional<Panel>& panel, std::size_t hidden_lines) {
    const auto body = panel ? std::optional(panel->body) : std::nullopt;
    if (body != body_) line_ = 0;
    body_ = body;
    last_ = static_cast<double>(hidden_lines);
  }
  /// Scrolls the panel's description by `lines`, positive towards its end, within its range.
  void move(double lines) { line_ = std::clamp(line_ + lines, 0.0, last_); }
  /// Returns the index of the first visible line of the panel's description.
  std::size_t line() const { return static_cast<std::size_t>(std::lround(line_)); }

 private:
  std::optional<BodyId> body_;
  double line_ = 0, last_ = 0;
};

}  // namespace prosector
