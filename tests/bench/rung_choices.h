#pragma once
// Elements and solvers that benchmarks compare.

#include <string>
#include <vector>

#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {

inline std::vector<std::string> element_names() {
  return {"tet4", "tet10"};  // SoftDesc::element has no table
}

inline std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const auto& row : soft::solvers()) names.emplace_back(row.name);
  return names;
}

}  // namespace prosector
