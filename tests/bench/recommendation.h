#pragma once
// Recommended model configurations for the measured machine.

#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

/// Describes a row's configuration in one line: model, element, integrator, solver and effort, tetrahedra,
/// step.
std::string in_words(const ReportRow& row);

/// Returns lines of text: for each case, the cheapest row within each error limit, and the most accurate row
/// within each frame-time budget. Bullet's rows are omitted: scenes cannot use them.
std::vector<std::string> recommend(const std::vector<ReportRow>& rows);

}  // namespace prosector
