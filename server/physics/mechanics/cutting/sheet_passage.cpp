#include "server/physics/mechanics/cutting/sheet_passage.h"

#include "common/assert.h"
#include "server/physics/mechanics/collision/primitives/segment_hit.h"

namespace prosector::cutting {

SheetPassage sheet_passage(const TetComplex& sheet, std::span<const TetId> triangles, std::span<const Vec3> x,
                           std::span<const Vec3> from, std::span<const Vec3> to) {
  PROSECTOR_ASSERT(sheet.is_sheet() && x.size() >= sheet.node_end());
  PROSECTOR_ASSERT(from.size() == to.size() && !from.empty());
  constexpr double slack = 1e-9;  // relative to a triangle: no gap between triangles with a common edge
  SheetPassage out;
  for (const TetId t : triangles) {
    const auto c = sheet.corners(t);
    const collision::Triangle corners = {x[c[0]], x[c[1]], x[c[2]]};
    const auto passes_through = [&](std::span<const Vec3> line) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (collision::segment_hit(line[i], line[i + 1], corners, slack)) return true;
      return false;
    };
    out.was_in = out.was_in || passes_through(from);
    out.is_in = out.is_in || passes_through(to);
    out.end_came_through = out.end_came_through ||
                           collision::segment_hit(from.front(), to.front(), corners, slack).has_value() ||
                           collision::segment_hit(from.back(), to.back(), corners, slack).has_value();
  }
  return out;
}

}  // namespace prosector::cutting
