#pragma once
// What prosector-bench can measure; each prints a table and returns its report.

#include <cstdint>
#include <string>
#include <vector>

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

struct BeamBenchOptions {
  std::vector<std::uint32_t> cells = {3, 6, 11};  // across; each makes 24n³ tetrahedra
  std::string model, solver;                      // only these rows; empty: all
  unsigned threads = 2;                           // from one to this many
};
/// The cantilever of other codes' figures: time against errors, moving and settled.
Report bench_beam(const BeamBenchOptions& options);

struct Beam101kBenchOptions {
  int steps = 60;
  std::string solver;    // only these rows; empty: all
  unsigned threads = 2;  // from one to this many
};
/// SOFA's published beam of 101,250 tetrahedra.
Report bench_beam101k(const Beam101kBenchOptions& options);

}  // namespace prosector
