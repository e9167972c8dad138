#pragma once
// Two panels of a page: side by side if there is room, else below each other.

#include <functional>

#include "client/setup/interface.h"

namespace prosector {

/// Draws two panels of a page by calling `left` and `right`: side by side if the page is wide enough,
/// otherwise below each other. `share`: fraction of the width for the left one.
void draw_side_by_side(Interface& ui, double share, const std::function<void()>& left,
                       const std::function<void()>& right);

}  // namespace prosector
