#pragma once
// One soft body stepped by the server's island solver, and what its steps cost.

#include "server/physics/mechanics/coupled/island_solver.h"
#include "tests/bench/report.h"
#include "tests/bench/text_table.h"

namespace prosector {

struct StepCost {
  double wall_ms = 0, cpu_ms = 0;  // cpu: of all threads together
  int newton = 0, iterations = 0;  // iterations: of the linear solver
  double residual = 0;             // relative, of the last linear solve
};

/// Means and medians over the steps of one phase.
class CostSummary {
 public:
  void add(const StepCost& cost) { costs_.push_back(cost); }
  double median_ms() const;  // wall clock
  double cpu_ms() const;     // median
  double newton() const;     // mean
  double iterations() const;
  double worst_residual() const;

 private:
  std::vector<StepCost> costs_;
};

/// `steps_per_s` and what else a report says of steps.
ReportRow figures(const CostSummary& cost);

/// A linear solver, and how much it is given: 1 Newton iteration or more, so many of its own at most.
struct SolverEffort {
  const char* name;
  int newton, iterations;
  double tolerance;
  void apply_to(SoftDesc& desc) const;
};

class SoftRun {
 public:
  SoftRun(const SoftDesc& desc, const Anatomy& anatomy);

  /// Contacts are those of this step alone; side a names body 0.
  StepCost step(double h, const Vec3& gravity, std::vector<Contact> contacts = {});
  /// Steps of h until nothing moves more than 1e-8 m in one, all velocities dropped whenever the kinetic
  /// energy has passed a maximum: the rest shape that these settings lead to. At most `steps`.
  void settle(double h, const Vec3& gravity, int steps);

  const SoftBody& body() const { return body_; }
  SoftBodyState& state() { return state_; }
  bool finite() const { return finite_; }

 private:
  SoftBody body_;
  SoftBodyState state_;
  IslandSolver solver_;
  bool finite_ = true;
};

/// The body's rung, effort and size, and the threads that are allowed now, as columns of a report.
ReportRow settings(const SoftBody& body, double dt);

/// Of runs along a path: solver and effort, then columns of `more` settings, what a step costs, how far off
/// the path it is, and `last`.
TextTable path_table(const std::vector<Column>& more, const Column& last);

/// Of the i-th node, at `gap` m from something fixed. `stiffness` N/m.
Contact node_contact(const VecX& x, Eigen::Index i, const Vec3& normal, double gap, double stiffness);

/// A pin of all nodes at x = x0, the first of a box's faces.
AttachDesc clamp_at(double x0, const Vec3& center);

}  // namespace prosector
