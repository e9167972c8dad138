#pragma once
// Blades in sheets, which have no inside. An edge passes through a sheet, or touches the sheet from above
// with its points.
//
// Where an edge passes through, a spring ties it to the sheet. The spring bears at most the toughness times
// the sheet's thickness: the force at which a crack of that length propagates. A point that touches the sheet
// from above stays there until toughness times its length of edge is exceeded. slicing() reduces both forces.

#include <span>
#include <vector>

#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/bodies.h"

namespace prosector {

/// Appends the ties between sheets and the points of the blade's edges to `grips`, and wakes the sheets.
/// `now` are the current positions of these points (m, world frame).
void grip_sheets(Bodies& bodies, std::vector<organs::BladeGrip>& grips, const organs::Blade& blade,
                 std::span<const Vec3> now);

/// Makes the free points of an edge that a sheet holds lag behind the blade as far as the nearest held point
/// does, by changing `from` and `to`. These are the swept motion of each edge point (m): from the last cut
/// position, which moves with the sheet, to the new one. `now` is where the blade has its edge points.
void drag_edges(const Bodies& bodies, std::span<const organs::BladeGrip> grips, const organs::Blade& blade,
                std::span<const Vec3> now, std::span<Vec3> from, std::span<Vec3> to);

/// Keeps the blade from passing through a tough sheet before the sheet yields. Edge points of the blade that
/// would cross the sheet from outside end at the sheet: their targets in `to` are changed. `from` and `to`
/// (m, by point) are the start and the end of the edge points' motion. Returns whether any edge is in a
/// sheet, or passed through one.
bool stop_at_sheets(const Bodies& bodies, std::span<const organs::BladeGrip> grips,
                    const organs::Blade& blade, std::span<const Vec3> from, std::span<Vec3> to);

}  // namespace prosector
