#pragma once
// Fade-out of items before an eye's near plane clips them.

#include <span>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes items of the list transparent where they are within the view and nearer to one of its eyes than
/// `near_fade_begins`. They are invisible before they reach the near plane, which would cut them open.
/// `items`: indices in the list.
void fade_near_eyes(DrawList& list, std::span<const std::size_t> items);

inline constexpr double near_fade_begins = 0.12;  // m ahead of the eye

}  // namespace prosector
