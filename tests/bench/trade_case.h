#pragma once
// The test cases of `prosector-bench trade`. Each defines its piece of tissue at a resolution, a load, and
// the reference solution.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "server/calibration/specimen.h"
#include "tests/bench/pressed_tissue.h"
#include "tests/bench/report.h"

namespace prosector {

/// Steps a body and measures the time of its steps.
class Runner {
 public:
  /// `dt`: s. `gravity`: m/s². Stops when the run would take more than `limit_ms` of CPU time in total.
  Runner(Steppable& body, double dt, const Vec3& gravity, double limit_ms)
      : body_(body), dt_(dt), gravity_(gravity), limit_ms_(limit_ms) {}
  /// Simulates `seconds` and calls `after(t)` after each step. Returns false if it stopped early or the state
  /// became non-finite.
  bool run(double seconds, const std::function<void(double)>& after);
  /// Returns `ms_per_frame` (CPU time of all threads per 1/60 s, median over steps), `ms_per_simulated_s`,
  /// `steps_per_s` (wall time), `residual` (largest), `simulated_s`, and `reported` (text) if a step reported
  /// a loss.
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
  const char* error_key;    // key of the figure that the plot shows
  const char* error_label;  // axis label of that figure
  /// Resolutions, coarsest first; cells along the longest side.
  std::vector<unsigned> cells;
  /// Builds the piece. Null for the cases with a ball (`pressed`).
  TestPiece (*piece)(unsigned cells);
  /// Runs the case and returns its figures, null where the run stopped early. `model` as in the report.
  ReportRow (*measure)(Specimen& specimen, const TestPiece& piece, const std::string& model, Runner& runner);
  Vec3 gravity;
  bool moving = false;  // whether the case tests motion, so that time steps and integrators are varied
  /// Computes the errors of a row from its figures. Null if errors can only be computed during the run.
  void (*judge)(ReportRow& row) = nullptr;
  const PressedBody* pressed = nullptr;  // body pressed by a ball in the server's simulation; null: none
};

/// bend: static deflection of a beam under its own weight.
const TradeCase& bend_case();
/// bend_incompressible: the beam at ν = 0.45, where linear tetrahedra lock.
const TradeCase& bend_incompressible_case();
/// swing: undamped oscillation of a beam in its first bending mode.
const TradeCase& swing_case();
/// free: a thrown, spinning block; conservation of momentum, angular momentum and energy.
const TradeCase& free_case();
/// heavy: static displacement and volume of a nearly incompressible block under twice its own weight.
const TradeCase& heavy_case();
/// cube, slab, hang: tissue that stands on a bonded foot or hangs from it, under its own weight.
const TradeCase& cube_case();
const TradeCase& slab_case();
const TradeCase& hang_case();
/// press, organ: static force on a ball pressed into a bonded layer, and into an organ.
const TradeCase& press_case();
const TradeCase& organ_case();

std::vector<const TradeCase*> trade_cases();
std::vector<std::string> trade_case_names();

}  // namespace prosector
