#pragma once
// Plot of a pressed layer's force error against its cell size.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Plots the rows of the case hertz that have a cell size, one line per element and layer.
Svg draw_hertz(const std::vector<ReportRow>& rows);

}  // namespace prosector
