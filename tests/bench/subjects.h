#pragma once
// What prosector-bench can measure; each prints a table and returns its figures.

#include <nlohmann/json.hpp>

namespace prosector {

struct SoftBenchOptions {
  unsigned tets = 4000;  // about
  unsigned threads = 1;
  int repeats = 51;
};
/// The calls of a Newton iteration on a pressed box of tetrahedra, for every law.
nlohmann::json bench_soft(const SoftBenchOptions& options);

}  // namespace prosector
