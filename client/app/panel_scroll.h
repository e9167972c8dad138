#pragma once
// The line from which a viewer reads the description on their panel.

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/messages.h"

namespace prosector {

class PanelScroll {
 public:
  /// Follows what panel there is; `hidden_lines`: of its description, which do not fit on it. The panel of
  /// another part is read from its first line on.
  void follow(const std::optional<Panel>& panel, std::size_t hidden_lines) {
    const auto body = panel ? std::optional(panel->body) : std::nullopt;
    if (body != body_) line_ = 0;
    body_ = body;
    last_ = static_cast<double>(hidden_lines);
  }
  /// Moves on by so many lines, no farther than to the description's end.
  void move(double lines) { line_ = std::clamp(line_ + lines, 0.0, last_); }
  /// Returns the first line that is seen.
  std::size_t line() const { return static_cast<std::size_t>(std::lround(line_)); }

 private:
  std::optional<BodyId> body_;
  double line_ = 0, last_ = 0;
};

}  // namespace prosector
