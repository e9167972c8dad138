#pragma once
// Test cases of the error estimator: estimated error of soft bodies against their true error.

#include <string>
#include <vector>

#include "server/accuracy/act.h"
#include "tests/bench/report.h"

namespace prosector {

/// A body and its loads.
struct EstimateCase {
  std::string name;
  SoftDesc desc;  // scene description; model and element are varied
  Anatomy mesh;
  std::vector<Act> acts;
};

/// Returns the cases: a bending beam, a standing and hanging cube, a slab, a layer and a liver, each under
/// its weight and pressed by a fingertip, with Poisson's ratios 0.3, 0.45 and 0.49. `quick`: only a coarse
/// cube with one ratio.
std::vector<EstimateCase> estimate_cases(bool quick);

/// Returns a row for each load (act), law (corotational, neo-Hookean) and element (linear, quadratic) of a
/// case.
///
/// The reference uses the tissue law on quadratic elements, each tetrahedron divided into eight, extrapolated
/// by a third of the difference from the undivided mesh; `unsettled` is that third. Errors are relative
/// errors of the compliance C = f·u, the work of the loads.
std::vector<ReportRow> judged(const EstimateCase& one);

}  // namespace prosector
