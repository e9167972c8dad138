#pragma once
// bench_haptics' pictures.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Draws the stiffest tissue that stays stable over the round trip, one line a scheme; rows are those of one
/// hand with jitter and loss.
Svg draw_stable_stiffness(const std::vector<ReportRow>& rows);
/// Draws felt over true stiffness over the tissue's, one line a scheme; rows are those of one round trip.
Svg draw_felt_stiffness(const std::vector<ReportRow>& rows);

}  // namespace prosector
