#pragma once
// What prosector-bench can measure; each prints a table and returns its report.

#include <string>

#include "tests/bench/report.h"

namespace prosector {

struct SoftBenchOptions {
  unsigned tets = 4000;  // about
  unsigned threads = 1;
  int repeats = 51;
};
/// The calls of a Newton iteration on a pressed box of tetrahedra, for every law.
Report bench_soft(const SoftBenchOptions& options);

struct RenderBenchOptions {
  unsigned triangles = 31000;  // about
  int width = 800, height = 600;
  int frames = 10;
  std::string picture_folder;  // where to write the pictures drawn; empty: nowhere
};
/// Frames of organs on a table in the room, whole and without one thing each. LP_NUM_THREADS=1 for steady
/// figures.
Report bench_render(const RenderBenchOptions& options);

}  // namespace prosector
