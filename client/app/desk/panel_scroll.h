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
  /// Updates to the present panel; `hidden_lines`: lines of its description that do not fit. The panel of
  /// another part starts at its first line.
  void follow(const std::optional<Panel>& panel, std::size_t hidden_lines) {
    const auto body = panel ? std::optional(panel->body) : std::nullopt;
    if (body != body_) line_ = 0;
    body_ = body;
    last_ = static_cast<double>(hidden_lines);
  }
  /// Scrolls by `lines`, clamped to the description.
  void move(double lines) { line_ = std::clamp(line_ + lines, 0.0, last_); }
  /// Returns the first visible line.
  std::size_t line() const { return static_cast<std::size_t>(std::lround(line_)); }

 private:
  std::optional<BodyId> body_;
  double line_ = 0, last_ = 0;
};

}  // namespace prosector
