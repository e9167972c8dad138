#pragma once
// Report columns of a model configuration.

#include "server/calibration/rung.h"
#include "tests/bench/report.h"

namespace prosector {

ReportRow settings(const Rung& rung);

}  // namespace prosector
