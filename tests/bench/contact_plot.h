#pragma once
// The error of a pressed layer's force against the size of its cells.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Of the rows of the hertz case that have a cell size; a line for each element and layer.
Svg draw_hertz(const std::vector<ReportRow>& rows);

}  // namespace prosector
