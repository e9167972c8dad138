#pragma once
// Two panels of a page: beside each other where there is room, else one below the other.

#include <functional>

#include "client/setup/interface.h"

namespace prosector {

/// Draws both. `share`: of the width that the left one has.
void draw_beside(Interface& ui, double share, const std::function<void()>& left,
                 const std::function<void()>& right);

}  // namespace prosector
