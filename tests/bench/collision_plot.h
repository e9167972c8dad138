#pragma once
// bench_collision's picture: what each fidelity costs and gets wrong, and how time grows.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

Svg draw_collision(const std::vector<ReportRow>& rows);

}  // namespace prosector
