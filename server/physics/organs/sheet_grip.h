#pragma once
// Blades in sheets, which have no inside: an edge goes through one, or comes down on it with its points.
//
// Where it goes through, it is tied to the sheet there by a spring. The spring bears the toughness times the
// sheet's thickness: the force at which a crack of that length goes on. A point that comes down on it stays
// above until what it stands for, toughness times length, is overcome. Both are less by slicing().

#include <span>
#include <vector>

#include "server/physics/bodies.h"
#include "server/physics/organs/blade_grip.h"

namespace prosector {

/// Appends where sheets hold the blade's edges, which are at `now`, back; wakes them.
void grip_sheets(Bodies& bodies, std::vector<BladeGrip>& grips, const Blade& blade,
                 std::span<const Vec3> now);

/// Lets all of an edge that a sheet holds back lag behind as it does there: each point as at the nearest
/// place. `from` goes with the sheet.
void drag_edges(const Bodies& bodies, std::span<const BladeGrip> grips, const Blade& blade,
                std::span<const Vec3> now, std::span<Vec3> from, std::span<Vec3> to);

/// Holds what comes to a tough sheet from outside where it does, until the sheet gives. Returns whether any
/// edge is in a sheet, or went through one.
bool stop_at_sheets(const Bodies& bodies, std::span<const BladeGrip> grips, const Blade& blade,
                    std::span<const Vec3> from, std::span<Vec3> to);

}  // namespace prosector
