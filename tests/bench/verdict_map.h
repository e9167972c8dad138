#pragma once
// Rungs against extremes, a coloured and lettered cell each: survives, degrades, refuses, fails.

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

struct VerdictCell {
  Verdict verdict = Verdict::fails;
  bool met_deadline = true;  // false: a frame took longer than the time it stands for
};

struct VerdictMap {
  std::string title, subtitle;
  std::vector<std::string> rungs, extremes;                    // rows, columns
  std::vector<std::vector<std::optional<VerdictCell>>> cells;  // [rung][extreme]; none: not run
};

Svg draw(const VerdictMap& map);

}  // namespace prosector
