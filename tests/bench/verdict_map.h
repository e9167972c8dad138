#pragma once
// SVG map of verdicts: one row per configuration, one column per extreme.

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

struct VerdictCell {
  Verdict verdict = Verdict::fails;
  bool met_deadline = true;  // false: the median frame took longer than its simulated time
};

struct VerdictMap {
  std::string title, subtitle;
  std::vector<std::string> rungs, extremes;                    // rows, columns
  std::vector<std::vector<std::optional<VerdictCell>>> cells;  // [configuration][extreme]; none: not run
};

Svg draw(const VerdictMap& map);

}  // namespace prosector
