#include "tests/bench/stability_run.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/integrators/time_integrator.h"
#include "tests/bench/text_table.h"
#include "tests/bench/two_organs.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;          // s
constexpr double near_enough = 1e-3;       // m
constexpr double energy_allowance = 0.01;  // fraction of the largest energy so far
constexpr double least_energy = 1e-9;      // J: smaller energies are rounding errors
constexpr int steps_between_looks = 10;    // between two shape checks
constexpr double still_speed = 1e-3;       // m/s
constexpr double still_seconds = 0.5;

class StabilityRun {
 public:
  StabilityRun(const StabilityRung& rung, const Extreme& extreme, double limit_ms)
      : extreme_(extreme),
        piece_(extreme.piece(rung.mesh)),
        limit_ms_(limit_ms),
        specimen_(make_specimen(rung.rung, piece_)),
        turns_(rung.rung.model != "fem_linear"),
        substepped_(is_substepped(rung.rung)) {
    result_.tets = specimen_->elements();
    result_.nodes = static_cast<std::size_t>(specimen_->node_mass().size());
    rest_ = specimen_->rest();
    VecX x = rest_, v = VecX::Zero(rest_.size());
    if (extreme.start) extreme.start(piece_, x, v);
    specimen_->set_motion(x, v);
  }

  StabilityResult run() {
    const bool whole = phase(extreme_.load_s, load()) && phase(extreme_.release_s, Vec3::Zero());
    result_.shape_error = off();
    if (!steps_ms_.empty()) {
      const double steps_a_frame = std::max(1.0, frame / extreme_.dt);
      result_.ms_per_frame = median(steps_ms_) * steps_a_frame;
      result_.steps_per_s = 1e3 / median(steps_ms_);
      result_.worst_ms_per_frame = *std::max_element(steps_ms_.begin(), steps_ms_.end()) * steps_a_frame;
      result_.met_deadline = result_.ms_per_frame <= 1e3 * std::max(frame, extreme_.dt);
    }
    judge(whole);
    return result_;
  }

 private:
  double off() const {
    return misfit(piece_, rest_, specimen_->positions(), specimen_->node_mass(), extreme_.release_s);
  }

  Vec3 load() const {
    if (extreme_.force == 0) return extreme_.load;
    return extreme_.force / specimen_->node_mass().sum() * extreme_.load.normalized();
  }

  /// Returns false if the state is not finite or the time limit is reached.
  bool phase(double seconds, const Vec3& gravity) {
    if (seconds <= 0) return true;
    const Vec3 pull = gravity.allFinite() ? gravity : Vec3(Vec3::Zero());  // ignore non-finite gravity
    double start = total_energy(pull);
    double largest = std::max(kinetic_energy(*specimen_) + specimen_->elastic_energy(), least_energy);
    const int steps = std::max(1, static_cast<int>(std::lround(seconds / extreme_.dt)));
    for (int i = 1; i <= steps; ++i) {
      const StepFigures figures = step(gravity);
      if (!specimen_->positions().allFinite() || !specimen_->velocities().allFinite()) {
        went_ = false;
        return false;
      }
      if (figures.reset || switched_) {  // restart the energy reference
        start = total_energy(pull);
        largest = std::max(kinetic_energy(*specimen_) + specimen_->elastic_energy(), least_energy);
      }
      largest = std::max(largest, kinetic_energy(*specimen_) + specimen_->elastic_energy());
      moved_ = moved_ || largest > least_energy;
      const double excess = (total_energy(pull) - start) / largest;
      if (std::isfinite(excess)) result_.energy_excess = std::max(result_.energy_excess, excess);
      if (gravity.isZero() && (i % steps_between_looks == 0 || i == steps)) look(i * extreme_.dt);
      if (spent_ms_ > limit_ms_ && i < steps) return false;
      if (gravity.isZero() && settled(extreme_.dt)) return true;
    }
    return true;
  }

  void look(double t) {
    back_ = off() < near_enough;
    if (back_ && result_.back_after_s < 0) result_.back_after_s = t;
  }

  /// Returns whether the body has recovered and kept its shape long enough to stop, even if it drifts or
  /// spins (unless its law is limited to small rotations). Methods that may amplify rounding errors run to
  /// the end.
  bool settled(double dt) {
    const bool still = (moved_ || !substepped_) && back_ && !recovering_ && deforming_speed() < still_speed;
    still_for_ = still ? still_for_ + dt : 0;
    return still_for_ > still_seconds;
  }

  static bool is_substepped(const Rung& rung) {
    return rung.is_position_based() ||
           std::none_of(soft::integrators().begin(), soft::integrators().end(),
                        [&](const soft::IntegratorRow& row) { return row.name == rung.integrator; });
  }

  /// Returns the largest node speed relative to the body's rigid motion, m/s.
  double deforming_speed() const {
    const VecX x = specimen_->positions(), &mass = specimen_->node_mass();
    VecX v = specimen_->velocities();
    if (turns_) {
      const Vec3 center = mass_center(*specimen_), drift = momentum(*specimen_) / mass.sum();
      Vec3 spin = Vec3::Zero();
      Mat3 inertia = Mat3::Zero();
      for (Eigen::Index i = 0; i < mass.size(); ++i) {
        const Vec3 arm = x.segment<3>(3 * i) - center;
        v.segment<3>(3 * i) -= drift;
        spin += mass[i] * arm.cross(Vec3(v.segment<3>(3 * i)));
        inertia += mass[i] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
      }
      const Vec3 omega =
          inertia.completeOrthogonalDecomposition().solve(spin);  // singular for a straight rope
      for (Eigen::Index i = 0; i < mass.size(); ++i)
        v.segment<3>(3 * i) -= omega.cross(Vec3(x.segment<3>(3 * i) - center));
    }
    return v.lpNorm<Eigen::Infinity>();
  }

  StepFigures step(const Vec3& gravity) {
    const double start = cpu_ms();
    const StepFigures figures = specimen_->step(extreme_.dt, gravity);
    steps_ms_.push_back(cpu_ms() - start);
    spent_ms_ += steps_ms_.back();
    ++result_.steps;
    last_converged_ = figures.converged;
    if (!figures.converged) ++result_.steps_not_converged;
    if (figures.guarded) ++result_.guarded;
    switched_ = figures.recovering != recovering_;
    if (switched_ && figures.recovering) ++result_.recoveries;
    recovering_ = figures.recovering;
    count(figures);
    if (std::isfinite(figures.residual)) result_.residual = std::max(result_.residual, figures.residual);
    return figures;
  }

  void count(const StepFigures& figures) {
    if (!figures.reset && !figures.reported) return;
    ++(figures.reset ? result_.resets : figures.refused ? result_.refusals : result_.losses);
    if (figures.reset || result_.resets == 0) result_.reason = figures.note;
  }

  double total_energy(const Vec3& gravity) {
    const double weight = gravity.isZero() ? 0 : specimen_->weight_energy(gravity);
    return kinetic_energy(*specimen_) + specimen_->elastic_energy() + weight;
  }

  void judge(bool whole) {
    const bool back = !extreme_.must_recover || result_.shape_error < near_enough;
    if (!went_) {
      fail("became non-finite");
    } else if (result_.energy_excess > energy_allowance) {
      fail(fmt::format("energy rose by {} %", three_digits(100 * result_.energy_excess)));
    } else if (!whole) {
      result_.reason = fmt::format("stopped after {:.0f} ms of CPU time", spent_ms_);
    } else if (back && result_.resets + result_.losses > 0) {
      result_.verdict = Verdict::degrades;
    } else if (back) {
      result_.verdict = result_.refusals > 0 ? Verdict::refuses : Verdict::survives;
    } else if (!last_converged_) {
      result_.verdict = Verdict::degrades;
      result_.reason = fmt::format("shape error {} mm, reported as not converged",
                                   three_digits(1e3 * result_.shape_error));
    } else {
      fail(fmt::format("unreported shape error of {} mm", three_digits(1e3 * result_.shape_error)));
    }
  }

  void fail(std::string reason) {
    result_.verdict = Verdict::fails;
    result_.reason = std::move(reason);
  }

  const Extreme& extreme_;
  TestPiece piece_;
  double limit_ms_, spent_ms_ = 0;
  std::unique_ptr<Specimen> specimen_;
  bool turns_;       // whether the law supports large rotations
  bool substepped_;  // whether the method takes substeps
  VecX rest_;
  std::vector<double> steps_ms_;
  bool went_ = true, last_converged_ = true, recovering_ = false, switched_ = false, moved_ = false;
  bool back_ = false;     // recovered at the last shape check
  double still_for_ = 0;  // s
  StabilityResult result_;
};

}  // namespace

StabilityResult run_extreme(const StabilityRung& rung, const Extreme& extreme, double limit_ms) {
  try {
    if (extreme.organs) return press_two_organs(rung.rung, limit_ms);
    return StabilityRun(rung, extreme, limit_ms).run();
  } catch (const InputError& error) {
    StabilityResult refused;
    refused.verdict = Verdict::refuses;
    refused.reason = error.what();
    return refused;
  }
}

}  // namespace prosector
