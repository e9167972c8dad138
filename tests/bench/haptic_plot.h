#pragma once
// Plots of bench_haptics.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Plots the largest stable tissue stiffness over the round-trip time, one line per scheme. `rows`: rows of
/// one hand, with jitter and loss.
Svg draw_stable_stiffness(const std::vector<ReportRow>& rows);
/// Plots perceived over true stiffness against tissue stiffness, one line per scheme. `rows`: rows of one
/// round-trip time.
Svg draw_felt_stiffness(const std::vector<ReportRow>& rows);

}  // namespace prosector
