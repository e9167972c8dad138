#pragma once
// A rung as the columns of a report.

#include "server/calibration/rung.h"
#include "tests/bench/report.h"

namespace prosector {

ReportRow settings(const Rung& rung);

}  // namespace prosector
