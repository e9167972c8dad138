#pragma once
// Passage of a blade's line through a sheet, which has no inside.

#include <span>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

struct SheetPassage {
  bool was_in = false, is_in = false;  // whether the line crossed the sheet before, and crosses it now
  /// Whether an end of the blade's line crossed the sheet during the motion. If so, the line did not leave
  /// the sheet across its border.
  bool end_came_through = false;
};

/// Returns how a blade's line passes through a sheet when it moves from polyline `from` to `to` (equally many
/// points, m). `triangles`: the sheet's triangles close to the line. `x`: node positions, m, by node id.
SheetPassage sheet_passage(const TetComplex& sheet, std::span<const TetId> triangles, std::span<const Vec3> x,
                           std::span<const Vec3> from, std::span<const Vec3> to);

}  // namespace prosector::cutting
