#pragma once
// Items of a list that go out before the near plane of an eye cuts them open.

#include <span>

#include "client/view/draw_list.h"

namespace prosector {

/// Fades items that come nearer to an eye of the list than `near_fade_begins`, within its picture. Before the
/// near plane they are gone.
void fade_near_eyes(DrawList& list, std::span<const std::size_t> items);

inline constexpr double near_fade_begins = 0.12;  // m ahead of the eye

}  // namespace prosector
