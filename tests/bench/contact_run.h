#pragma once
// A scene run by the server's own simulation, watched: what prosector-bench contact measures with.

#include <optional>
#include <string>
#include <vector>

#include "server/physics/simulation.h"
#include "tests/bench/report.h"
#include "tests/physics/scenes.h"

namespace prosector {

class ContactRun {
 public:
  /// One thread, so that times are a core's.
  explicit ContactRun(const SceneDesc& scene, const CompileOptions& options = test::options());

  const StepReport& step(const TickInput& input = {});
  void run(int ticks, const TickInput& input = {});  // events in the first only
  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  double h() const { return h_; }  // s

  int ticks() const { return ticks_; }
  bool finite() const { return finite_; }  // all positions, after every tick
  int resets() const { return resets_; }   // that steps reported, of any body
  int reported() const {
    return reported_;
  }                            // ticks of which the step reported a loss: a reset, or not converged
  double ms_per_tick() const;  // CPU, mean
  double quantile_ms(double share) const;  // CPU time of a tick that this share of the ticks kept to
  double median_ms() const { return quantile_ms(0.5); }
  double median_wall_ms() const;  // of a tick, by the clock
  void forget_times() {
    tick_ms_.clear();
    wall_ms_.clear();
  }
  double energy() const { return energy_; }  // J, last reported: kinetic, elastic and of weight
  double highest_energy() const { return highest_energy_; }
  const std::string& note() const { return note_; }  // what the first reset said

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

/// A figure beside what it should be: right when |measured − reference| ≤ tolerance. Without a tolerance it
/// is told only.
struct ContactFigure {
  std::string what, unit;
  double measured = 0, reference = 0;
  std::optional<double> tolerance;
};

/// Collects rows and prints each.
class ContactRows {
 public:
  explicit ContactRows(Report& report);
  void begin(const std::string& name) { case_ = name; }  // of the rows that follow
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

/// `contact_stiffness` of the presses that are compared with theory, ten times a scene's default: the
/// theory's ball is hard, so contacts are refined like the mesh.
constexpr double hertz_contact_stiffness = 200;

// The cases, each in its file.
void hertz_case(ContactRows& rows, bool quick);
void layer_case(ContactRows& rows, bool quick);
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

// What several of them measure.

/// Momentum of a body, kg·m/s; of a rigid one its mass is needed.
Vec3 soft_momentum(const Simulation& simulation, BodyId body);
Vec3 rigid_momentum(const Simulation& simulation, BodyId body, double mass);
/// Mean of a soft body's nodes, m.
Vec3 soft_centre(const Simulation& simulation, BodyId body);
/// Input that drives one body.
TickInput driving(BodyId body, const Pose& to);

}  // namespace prosector
