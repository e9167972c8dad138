#pragma once
// What a person should choose on the machine that was measured.

#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

/// A row's rung in one line: model, element, integrator, solver and effort, tetrahedra, step.
std::string in_words(const ReportRow& row);

/// Sentences: for each case, the cheapest row within each accuracy, and the best within each budget of a
/// frame. Peers' rows are left out: a scene can't choose them.
std::vector<std::string> recommend(const std::vector<ReportRow>& rows);

}  // namespace prosector
