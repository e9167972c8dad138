#pragma once
// bench_estimate's picture: what bodies tell of their error, against the error that they have.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// What is aimed at: the estimate over the error.
inline constexpr double least_effectivity = 0.8, most_effectivity = 1.5;

Svg draw_estimates(const std::vector<ReportRow>& rows);

}  // namespace prosector
