#pragma once
// Steps one soft body with the server's island solver and measures the cost.

#include "server/physics/mechanics/coupled/island_solver.h"
#include "tests/bench/report.h"
#include "tests/bench/text_table.h"

namespace prosector {

struct StepCost {
  double wall_ms = 0, cpu_ms = 0;  // cpu: all threads
  int newton = 0, iterations = 0;  // iterations of the linear solver
  double residual = 0;             // relative residual of the last linear solve
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

/// Returns `steps_per_s` and the other cost columns of a report.
ReportRow figures(const CostSummary& cost);

/// Linear solver with its budget: number of Newton iterations (at least 1) and maximum of its own iterations.
struct SolverEffort {
  const char* name;
  int newton, iterations;
  double tolerance;
  void apply_to(SoftDesc& desc) const;
};

class SoftRun {
 public:
  SoftRun(const SoftDesc& desc, const Anatomy& anatomy);

  /// Takes one step with these contacts. Side a of each contact names body 0.
  StepCost step(double h, const Vec3& gravity, std::vector<contact::Contact> contacts = {});
  /// Finds the equilibrium: takes at most `steps` steps of h until no node moves more than 1e-8 m in a step.
  /// Velocities are zeroed whenever the kinetic energy has passed a maximum.
  void settle(double h, const Vec3& gravity, int steps);

  const soft::SoftBody& body() const { return body_; }
  soft::SoftBodyState& state() { return state_; }
  bool finite() const { return finite_; }

 private:
  soft::SoftBody body_;
  soft::SoftBodyState state_;
  coupled::IslandSolver solver_;
  bool finite_ = true;
};

/// Returns report columns with the body's configuration, effort, size and number of threads.
ReportRow settings(const soft::SoftBody& body, double dt);

/// Returns a text table for runs along a path: solver and effort, the settings `more`, cost of a step, path
/// error, and the column `last`.
TextTable path_table(const std::vector<Column>& more, const Column& last);

/// Returns a contact of node i with a fixed object at distance `gap`, m. `stiffness`: N/m.
contact::Contact node_contact(const VecX& x, Eigen::Index i, const Vec3& normal, double gap,
                              double stiffness);

/// Returns an attachment of all nodes at x = x0, the first face of a box.
AttachDesc clamp_at(double x0, const Vec3& center);

}  // namespace prosector
