#pragma once
// The reference cases that rungs are weighed on. Each knows its piece of tissue at a resolution, what to do
// with it, and the right answer.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "server/calibration/specimen.h"
#include "tests/bench/pressed_tissue.h"
#include "tests/bench/report.h"

namespace prosector {

/// Runs a body step by step and takes the time of it.
class Runner {
 public:
  /// Gives up once the run would take longer than `limit_ms` of CPU time in all.
  Runner(Steppable& body, double dt, const Vec3& gravity, double limit_ms)
      : body_(body), dt_(dt), gravity_(gravity), limit_ms_(limit_ms) {}
  /// Steps for that long, s; after each step calls `after(t)`. False: gave up, or went non-finite.
  bool run(double seconds, const std::function<void(double)>& after);
  /// ms_per_frame (CPU, all threads, of 1/60 s; median over steps), ms_per_simulated_s, steps_per_s (by the
  /// clock on the wall), residual (largest), simulated_s, and `reported` when a step said that it lost
  /// something.
  ReportRow figures() const;
  bool finite() const { return finite_; }

 private:
  Steppable& body_;
  double dt_;
  Vec3 gravity_;
  double limit_ms_;
  std::vector<double> step_cpu_ms_;
  double wall_ms_ = 0, cpu_ms_ = 0, residual_ = 0;
  std::string note_;
  bool finite_ = true;
};

struct TradeCase {
  const char* name;
  const char* title;
  const char* error_key;    // the figure that the picture draws
  const char* error_label;  // what it is, for people
  /// Resolutions, coarsest first; cells along the longest side.
  std::vector<unsigned> cells;
  /// Null where a ball presses: see `pressed`.
  TestPiece (*piece)(unsigned cells);
  /// Runs it and returns the case's own figures (null: it did not get that far). `model` as in the report.
  ReportRow (*measure)(Specimen& specimen, const TestPiece& piece, const std::string& model, Runner& runner);
  Vec3 gravity;
  bool moving = false;  // judged by how it moves: steps and integrators matter
  /// Errors from the figures of a row, if it has them, where that can be done: null, where it takes the run.
  void (*judge)(ReportRow& row) = nullptr;
  const PressedBody* pressed = nullptr;  // by a ball, in the server's own simulation
};

/// bend: a beam under its own weight, at rest again.
const TradeCase& bend_case();
/// bend_incompressible: the same at ν = 0.45, where linear tetrahedra lock.
const TradeCase& bend_incompressible_case();
/// swing: the beam in its first bending mode, undamped.
const TradeCase& swing_case();
/// free: a block thrown and spinning: momentum, angular momentum and energy.
const TradeCase& free_case();
/// heavy: a nearly incompressible block under twice its own weight: volume.
const TradeCase& heavy_case();
/// cube, slab, hang: tissue that stands on a bonded foot, or hangs from it, by its own weight.
const TradeCase& cube_case();
const TradeCase& slab_case();
const TradeCase& hang_case();
/// press, organ: a ball pressed into a bonded layer, and into an organ.
const TradeCase& press_case();
const TradeCase& organ_case();

std::vector<const TradeCase*> trade_cases();
std::vector<std::string> trade_case_names();

}  // namespace prosector
