#pragma once
// Passage of a blade's line through a sheet, which has no inside.

#include <span>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

struct SheetPassage {
  bool was_in = false, is_in = false;  // whether the line crossed the sheet before, and crosses it now
  /// Whether an end of the line crossed the sheet in between. If so, the line did not leave across the
  /// sheet's border.
  bool end_came_through = false;
};

/// Returns the passage of a line that moves from `from` to `to` (equally many points) through nearby
/// `triangles` of a sheet. `x`: m, by node id.
SheetPassage sheet_passage(const TetComplex& sheet, std::span<const TetId> triangles, std::span<const Vec3> x,
                           std::span<const Vec3> from, std::span<const Vec3> to);

}  // namespace prosector
