#pragma once
// Runs a scene in the server's simulation and records what prosector-bench contact reports.

#include <optional>
#include <string>
#include <vector>

#include "server/physics/simulation.h"
#include "tests/bench/report.h"
#include "tests/physics/scenes.h"

namespace prosector {

class ContactRun {
 public:
  /// Compiles the scene. Runs on one thread by default, so that times are those of one core.
  explicit ContactRun(const SceneDesc& scene, const CompileOptions& options = test::options());

  const StepReport& step(const TickInput& input = {});
  void run(int ticks, const TickInput& input = {});  // events are sent in the first tick only
  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  double h() const { return h_; }  // s, tick duration

  int ticks() const { return ticks_; }
  bool finite() const { return finite_; }  // whether all positions were finite after every tick
  int resets() const { return resets_; }   // resets of bodies that steps reported
  /// Returns the number of ticks whose step reported a loss: a reset, or a solver that had not converged.
  int reported() const { return reported_; }
  double ms_per_tick() const;              // mean CPU time
  double quantile_ms(double share) const;  // quantile of the ticks' CPU time; share: 0 … 1
  double median_ms() const { return quantile_ms(0.5); }
  double median_wall_ms() const;  // median wall time of a tick
  void forget_times() {
    tick_ms_.clear();
    wall_ms_.clear();
  }
  double energy() const { return energy_; }  // J, last reported kinetic + elastic + potential energy
  double highest_energy() const { return highest_energy_; }
  const std::string& note() const { return note_; }  // message of the first reset

 private:
  void watch(const StepReport& report);

  Simulation simulation_;
  double h_;
  int ticks_ = 0, resets_ = 0, reported_ = 0;
  bool finite_ = true;
  std::vector<double> tick_ms_, wall_ms_;
  double energy_ = 0, highest_energy_ = 0;
  std::string note_;
};

/// A measured value with its reference: correct if |measured − reference| ≤ tolerance. Without a tolerance it
/// is reported but not judged.
struct ContactFigure {
  std::string what, unit;
  double measured = 0, reference = 0;
  std::optional<double> tolerance;
};

/// Adds rows to a report and prints them.
class ContactRows {
 public:
  explicit ContactRows(Report& report);
  void begin(const std::string& name) { case_ = name; }  // case name of the following rows
  void add(const ContactRun& run, const std::string& setting, const ContactFigure& figure,
           ReportRow more = {});

 private:
  Report& report_;
  std::string case_;
};

struct ContactCase {
  const char* name;
  void (*measure)(ContactRows& rows, bool quick);
};
const std::vector<ContactCase>& contact_cases();

/// `contact_stiffness` of the presses that are compared with theory: ten times a scene's default, because the
/// ball of the theory is rigid.
constexpr double hertz_contact_stiffness = 200;

// The cases, each defined in its own file.
void hertz_case(ContactRows& rows, bool quick);
void layer_case(ContactRows& rows, bool quick);
void usual_case(ContactRows& rows, bool quick);
void organ_case(ContactRows& rows, bool quick);
void incline_case(ContactRows& rows, bool quick);
void exchange_case(ContactRows& rows, bool quick);
void ratio_case(ContactRows& rows, bool quick);
void pour_case(ContactRows& rows, bool quick);
void squeeze_case(ContactRows& rows, bool quick);
void probe_case(ContactRows& rows, bool quick);
void teleport_case(ContactRows& rows, bool quick);
void falling_boxes_case(ContactRows& rows, bool quick);
void held_case(ContactRows& rows, bool quick);
void thrown_case(ContactRows& rows, bool quick);

// Helpers of several cases.

/// Returns the momentum of a soft or rigid body, kg·m/s. `mass`: mass of the rigid body, kg.
Vec3 soft_momentum(const Simulation& simulation, BodyId body);
Vec3 rigid_momentum(const Simulation& simulation, BodyId body, double mass);
/// Returns the mean position of a soft body's nodes, m.
Vec3 soft_centre(const Simulation& simulation, BodyId body);
/// Returns input that moves a kinematic body to the pose `to`.
TickInput driving(BodyId body, const Pose& to);

}  // namespace prosector
