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

/// Appends the ties between sheets and the blade's edges, whose points are at `now`, and wakes the sheets.
void grip_sheets(Bodies& bodies, std::vector<BladeGrip>& grips, const Blade& blade,
                 std::span<const Vec3> now);

/// Makes the other points of an edge that a sheet holds lag like the nearest held point. `from` moves with
/// the sheet.
void drag_edges(const Bodies& bodies, std::span<const BladeGrip> grips, const Blade& blade,
                std::span<const Vec3> now, std::span<Vec3> from, std::span<Vec3> to);

/// Stops points that reach a tough sheet from outside at the sheet, until it yields. Returns whether any edge
/// is in a sheet, or passed through one.
bool stop_at_sheets(const Bodies& bodies, std::span<const BladeGrip> grips, const Blade& blade,
                    std::span<const Vec3> from, std::span<Vec3> to);

}  // namespace prosector
