#pragma once
// How a blade's line goes through a sheet, which has no inside that it could be in.

#include <span>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

struct SheetPassage {
  bool was_in = false, is_in = false;  // the line went through the sheet; does now
  bool end_came_through = false;       // an end of it did in between: no way across the sheet's border
};

/// Returns the passage of a line that goes from `from` to `to`, as many points each, through what is near it
/// of a sheet (`triangles`). `x`: m, by node id.
SheetPassage sheet_passage(const TetComplex& sheet, std::span<const TetId> triangles, std::span<const Vec3> x,
                           std::span<const Vec3> from, std::span<const Vec3> to);

}  // namespace prosector
