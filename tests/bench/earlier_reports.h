#pragma once
// Reports that a benchmark wrote before, so that parts of it can run separately.

#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

/// Reads reports that `prosector-bench BENCH --json` wrote. Throws InputError that names a file which is
/// none.
std::vector<ReportRow> read_reports(const std::string& bench, const std::vector<std::string>& files);

/// Returns machine, date and commit of the reports.
ReportRow origins(const std::vector<ReportRow>& reports);

}  // namespace prosector
