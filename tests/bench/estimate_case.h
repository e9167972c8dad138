#pragma once
// Bodies whose live estimate of their own error is compared with the error that they have.

#include <string>
#include <vector>

#include "server/accuracy/act.h"
#include "tests/bench/report.h"

namespace prosector {

/// A body, and what is done to it.
struct EstimateCase {
  std::string name;
  SoftDesc desc;  // but for model and element
  Anatomy mesh;
  std::vector<Act> acts;
};

/// Returns the cases: a beam that bends, a cube that stands and hangs, a slab, a layer, a liver, each under
/// its weight and pressed by a fingertip; Poisson's ratios 0.3, 0.45 and 0.49. `quick`: the cube alone,
/// coarse, at one.
std::vector<EstimateCase> estimate_cases(bool quick);

/// Returns a row for each act, law (corotational, neo-Hookean) and element (linear, quadratic) of a case.
///
/// The truth is tissue's law in quadratic elements, each tetrahedron divided into eight, and a third of what
/// that differs by from the undivided. That third is `unsettled`. Errors are of C = f·u, how far the loads
/// go.
std::vector<ReportRow> judged(const EstimateCase& one);

}  // namespace prosector
